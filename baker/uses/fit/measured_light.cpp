// SPDX-License-Identifier: MIT
#include "uses/fit/measured_light.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>

#include "files/whole_file.h"
#include "uses/plot/plot.h"

namespace coppermoon::uses {
namespace {

using Nights = std::span<const std::vector<MeasuredLight>>;

constexpr std::array channel_names{"R", "G", "B"};
constexpr std::array channel_colours{"#c02020", "#108030", "#2040c0"};

std::string as_csv(Nights nights) {
  std::string text = "night,distance_km,channel,light,error,model\n";
  for (std::size_t n = 0; n < nights.size(); ++n)
    for (const auto& [distance_km, channel, light, model, error] : nights[n])
      text += fmt::format("{},{:.1f},{},{:.6g},{:.3g},{:.6g}\n", n + 1, distance_km,
                          channel_names[channel], light, error, model);
  return text;
}

Plot plot_of(Nights nights) {
  std::vector<PlotCurve> curves;
  for (std::size_t k = 0; k < channel_names.size(); ++k) {
    std::string light, model;
    for (const auto& night : nights) {
      for (const auto& measured : night)
        if (measured.channel == k) {
          light += fmt::format("{:.1f},{:.6g},{:.6g},{:.6g}\n", measured.distance_km,
                               measured.light, measured.light * std::exp(-measured.error),
                               measured.light * std::exp(measured.error));
          model += fmt::format("{:.1f},{:.6g}\n", measured.distance_km, measured.model);
        }
      model += '\n';  // an empty line keeps the plot from joining two nights
    }
    const std::string name = channel_names[k],
                      colour = fmt::format("lc rgb '{}'", channel_colours[k]);
    curves.push_back({light, "yerrorbars pt 7 ps 0.6 " + colour, name});
    curves.push_back({model, "lines lw 1.5 " + colour, name + ", model"});
  }
  return {.x = {.label = "distance from the shadow's axis [km]"},
          .panels = {{{.label = "light over full sunlight", .logarithmic = true}, curves}},
          .key = "outside right top"};
}

}  // namespace

void require_light_file(const std::filesystem::path& file) {
  require_plot_ending(file, "light by distance", true);
  files::require_place_for(file);
}

void write_measured_light(const std::filesystem::path& file, Nights nights) {
  require_light_file(file);
  if (file.extension() == ".csv") return files::write_whole(file, as_csv(nights));
  write_plot(file, plot_of(nights));
}

}  // namespace coppermoon::uses
