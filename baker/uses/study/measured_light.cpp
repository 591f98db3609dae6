// SPDX-License-Identifier: MIT
#include "uses/study/measured_light.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "algebra/error.h"
#include "files/whole_file.h"
#include "uses/picture/gnuplot.h"

namespace coppermoon::uses {
namespace {

using Nights = std::span<const std::vector<MeasuredLight>>;

constexpr std::array channel_names{"R", "G", "B"};
constexpr std::array channel_colours{"#c02020", "#108030", "#2040c0"};
constexpr std::array endings{".csv", ".png", ".svg", ".pdf"};

std::string as_csv(Nights nights) {
  std::string text = "night,distance_km,channel,light,error,model\n";
  for (std::size_t n = 0; n < nights.size(); ++n)
    for (const auto& [distance_km, channel, light, model, error] : nights[n])
      text += fmt::format("{},{:.1f},{},{:.6g},{:.3g},{:.6g}\n", n + 1, distance_km,
                          channel_names[channel], light, error, model);
  return text;
}

const char* terminal_of(const std::filesystem::path& picture) {
  if (picture.extension() == ".svg") return "svg size 1000,640 dynamic font 'Sans,14'";
  if (picture.extension() == ".pdf") return "pdfcairo size 25cm,16cm font 'Sans,14'";
  return "pngcairo size 1000,640 font 'Sans,12'";
}

std::string plot_script(Nights nights) {
  std::string data, plot;
  for (std::size_t k = 0; k < channel_names.size(); ++k) {
    data += fmt::format("${} << EOD\n", channel_names[k]);
    for (const auto& night : nights) {
      for (const auto& measured : night)
        if (measured.channel == k)
          data += fmt::format("{:.1f} {:.6g} {:.6g} {:.6g} {:.6g}\n", measured.distance_km,
                              measured.light, measured.light * std::exp(-measured.error),
                              measured.light * std::exp(measured.error), measured.model);
      data += '\n';  // no line from one night to the next
    }
    data += "EOD\n";
    plot += fmt::format(
        "{0} ${1} using 1:2:3:4 with yerrorbars pointtype 7 pointsize 0.6 linecolor rgb '{2}' "
        "title "
        "'{1}', ${1} using 1:5 with lines linewidth 1.5 linecolor rgb '{2}' title '{1}, model'",
        k == 0 ? "plot" : ",", channel_names[k], channel_colours[k]);
  }
  return data +
         "set encoding utf8\nset logscale y\nset format y '10^{%L}'\nset grid\nset key outside "
         "right top\n"
         "set xlabel \"distance from the shadow's axis [km]\"\n"
         "set ylabel 'light over full sunlight'\n" +
         plot + '\n';
}

}  // namespace

void require_light_file(const std::filesystem::path& file) {
  if (std::ranges::find(endings, file.extension().string()) == endings.end())
    throw algebra::Error(
        fmt::format("{}: light by distance ends in .csv, .png, .svg or .pdf", file.string()));
  files::require_place_for(file);
}

void write_measured_light(const std::filesystem::path& file, Nights nights) {
  require_light_file(file);
  if (file.extension() == ".csv") return files::write_whole(file, as_csv(nights));
  write_plot(file, terminal_of(file), plot_script(nights));
}

}  // namespace coppermoon::uses
