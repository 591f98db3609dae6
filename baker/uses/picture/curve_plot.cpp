// SPDX-License-Identifier: MIT
#include "uses/picture/curve_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace coppermoon::uses {
namespace {

/// Hours and a column; a row without a number interrupts the line.
std::string rows_of(const LightCurve& curve, const eclipse::Eclipse& eclipse,
                    const std::vector<double>& numbers) {
  std::string rows;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    rows += std::isfinite(numbers[i])
                ? fmt::format("{:.6f},{:.6g}\n",
                              hours_from_greatest(eclipse, curve.moments[i].brightness.instant),
                              numbers[i])
                : "\n";
  return rows;
}

}  // namespace

double hours_from_greatest(const eclipse::Eclipse& eclipse, const almanac::Instant& when) {
  return almanac::seconds_between(eclipse.greatest, when) / 3600;
}

Plot plot_over(const eclipse::Eclipse& eclipse, const almanac::Instant& from,
               const almanac::Instant& to) {
  const double first = hours_from_greatest(eclipse, from), last = hours_from_greatest(eclipse, to),
               margin = std::max(1e-3, (last - first) / 50), low = first - margin,
               high = last + margin;
  std::vector<PlotMark> marks;
  for (const auto& [name, when] : contacts_of(eclipse))
    if (const double at = hours_from_greatest(eclipse, when); at >= low && at <= high)
      marks.push_back({PlotMark::instant, at, name});
  return {.title = title(eclipse),
          .title_size = 15,
          .width = 1100,
          .height = 760,
          .x = {.label = "hours from greatest eclipse", .range = {{low, high}}},
          .marks = marks,
          .grid = "lt 1 lc rgb '#eeeeee'"};
}

Plot plot_of(const LightCurve& curve, const eclipse::Eclipse& eclipse, const std::string& place) {
  auto plot = plot_over(eclipse, curve.moments.front().brightness.instant,
                        curve.moments.back().brightness.instant);
  plot.panels = {{{.label = "magnitude", .reversed = true}, {}},
                 {{.label = "illuminance, facing the Moon [lx]", .logarithmic = true}, {}}};
  const std::map<std::string, const char*> colours{
      {"B", "#2f6fb5"}, {"V", "#3f9142"}, {"R", "#b0432b"}};
  for (const auto& [name, numbers] : curve.columns) {
    const bool seen = name.starts_with("seen_"), of_band = name.ends_with("_magnitude");
    const auto what = name.substr(seen ? 5 : 0), band = what.substr(0, what.find('_'));
    if (!of_band && what != "illuminance_lx") continue;
    plot.panels[of_band ? 0 : 1].curves.push_back(
        {rows_of(curve, eclipse, numbers),
         fmt::format("lines lw 2 lc rgb '{}'{}", of_band ? colours.at(band) : "#333333",
                     seen ? " dashtype 2" : ""),
         of_band ? (seen ? "" : band) : (seen ? "through the air" : "above the air")});
  }
  if (!place.empty()) plot.title += ", from " + place;
  plot.key = "bottom left Left reverse";
  return plot;
}

}  // namespace coppermoon::uses
