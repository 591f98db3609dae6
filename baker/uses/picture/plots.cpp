// SPDX-License-Identifier: MIT
#include "uses/picture/plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec3.hpp>
#include <map>

#include "colour/cie_observer.h"
#include "colour/srgb.h"
#include "colour/working_space.h"
#include "eclipse/shadow_cone.h"

namespace coppermoon::uses {
namespace {

constexpr double km = 1e3;

/// Range of the plot's vertical axis: from the decade below the darkest light shown to above full sunlight.
std::pair<double, double> range_of(const ShadowProfile& profile) {
  double darkest = 1;
  for (const double ratio : profile.ratio.values())
    if (ratio > 1e-12) darkest = std::min(darkest, ratio);
  return {std::pow(10, std::floor(std::log10(darkest))), 3};
}

std::optional<PlotMark> moon_mark(double centre_m, double end_m) {
  const double radius_m = algebra::in_metres(almanac::lunar_radius);
  const double from = std::max(0., centre_m - radius_m) / km,
               to = std::min(end_m, centre_m + radius_m) / km;
  if (from >= to) return {};
  return PlotMark{PlotMark::band, from, "Moon", to};
}

std::vector<PlotCurve> curves(const ShadowProfile& profile) {
  std::vector<PlotCurve> curves;
  for (std::size_t w = 0; w < profile.wavelengths_nm.size(); ++w) {
    const double nm = profile.wavelengths_nm[w];
    std::string rows;
    for (std::size_t d = 0; d < profile.axis_distances_m.size(); ++d) {
      const double ratio = profile.ratio(d, w);
      rows +=
          fmt::format("{:g},{:.6g}\n", profile.axis_distances_m[d] / km, ratio > 0 ? ratio : NAN);
    }
    curves.push_back({rows, fmt::format("lines lw 2.5 lc rgb '{}'", plot_colour(nm)),
                      fmt::format("{:g} nm", nm)});
  }
  return curves;
}

/// A curve's rows for gnuplot: the hour and the number at each moment. An empty row leaves a gap in the line.
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

std::string plot_colour(double wavelength_nm) {
  using enum colour::WorkingSpace;
  const auto weights = colour::xyz_weights(std::array{wavelength_nm - 0.5, wavelength_nm + 0.5});
  auto channels = colour::channels_from_xyz(linear_rec709) *
                  glm::dvec3(weights(0, 0), weights(1, 0), weights(2, 0));
  double most = 0;
  for (int c = 0; c < 3; ++c) most = std::max(most, channels[c] = std::max(0., channels[c]));
  channels /= most;
  constexpr double brightest = 0.25;  // brighter lines are hard to see on white (contrast 3.5 to 1)
  const double luminance =
      colour::luminance(linear_rec709, std::array{channels.x, channels.y, channels.z});
  constexpr double well_seen = 0.1;  // relative to 555 nm; less visible light is drawn darker
  const double efficiency = weights(1, 0) / colour::luminous_efficacy_lm_per_W;
  channels *=
      std::min(1., brightest / luminance) * std::pow(std::min(1., efficiency / well_seen), 0.2);
  const auto code = [](double linear) { return std::lround(255 * colour::srgb_code(linear)); };
  return fmt::format("#{:02x}{:02x}{:02x}", code(channels.x), code(channels.y), code(channels.z));
}

ShadowMarks marks_of(const shadow::Arrangement& cut, const std::optional<almanac::SkyState>& sky,
                     std::string title) {
  auto axis = eclipse::ShadowAxis{glm::dmat3(1), algebra::metres(cut.sun_distance_m)};
  const eclipse::ShadowPlace on_axis{algebra::metres(0), algebra::radians(0),
                                     algebra::metres(cut.depths_m.front())};
  const auto radii = eclipse::shadow_radii(eclipse::ShadowConvention::danjon, axis, on_axis);
  const auto radius_m = [&](algebra::Angle seen) {
    return algebra::in_metres(eclipse::axis_distance_at(seen, on_axis));
  };
  ShadowMarks marks{std::move(title), radius_m(radii.umbra), radius_m(radii.penumbra)};
  if (sky) marks.moon_m = algebra::in_metres(eclipse::moon_in_shadow(*sky).axis_distance);
  return marks;
}

void write_shadow_plot(const std::filesystem::path& picture, const ShadowProfile& profile,
                       const ShadowMarks& marks) {
  const double end_m = profile.axis_distances_m.back();
  Plot plot{.title = marks.title,
            .x = {.label = "Distance from the middle of the shadow [km]",
                  .range = {{0, std::max(end_m, km) / km}}},
            .panels = {{{.label = "Light, as a fraction of full sunlight",
                         .range = range_of(profile),
                         .logarithmic = true},
                        curves(profile)}},
            .key = "top left"};
  if (marks.moon_m)
    if (const auto moon = moon_mark(*marks.moon_m, end_m)) plot.marks.push_back(*moon);
  if (marks.umbra_m > 0 && marks.umbra_m < end_m)
    plot.marks.push_back({PlotMark::edge, marks.umbra_m / km, "edge of the umbra"});
  if (marks.penumbra_m < end_m)
    plot.marks.push_back({PlotMark::edge, marks.penumbra_m / km, "edge of the penumbra"});
  write_plot(picture, plot);
}

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
