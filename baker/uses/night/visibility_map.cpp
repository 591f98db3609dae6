// SPDX-License-Identifier: MIT
#include "uses/night/visibility_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "algebra/error.h"
#include "almanac/calendar.h"
#include "almanac/lunar_orientation.h"
#include "night/tables.h"
#include "uses/plot/plot.h"

namespace coppermoon::uses {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// The place where the Moon is at the zenith, and the largest angular distance from it at which the Moon is seen [rad].
struct UnderMoon {
  double latitude, longitude, reach;
};

UnderMoon under_moon(const almanac::Instant& when) {
  const auto sky = almanac::sky_at(when);
  const auto zenith = [&](double latitude_deg, double longitude_deg) {
    return almanac::view_from({algebra::degrees(latitude_deg), algebra::degrees(longitude_deg), {}},
                              sky)
        .zenith;
  };
  const auto moon = glm::normalize(sky.moon_m);
  const double x = glm::dot(moon, zenith(0, 0)), y = glm::dot(moon, zenith(0, 90)),
               z = glm::dot(moon, zenith(90, 0)), distance_m = glm::length(sky.moon_m);
  constexpr double earth_radius_m = 6.371e6, refraction = 34. / 60 * degree;
  const double parallax = std::asin(earth_radius_m / distance_m),
               semidiameter = std::asin(algebra::in_metres(almanac::lunar_radius) / distance_m);
  return {std::asin(z), std::atan2(y, x),
          std::numbers::pi / 2 - parallax + refraction + semidiameter};
}

/// Cosine of the angular distance between a place and the place where the Moon is at the zenith.
double nearness(const UnderMoon& moon, double latitude, double longitude) {
  return std::sin(latitude) * std::sin(moon.latitude) +
         std::cos(latitude) * std::cos(moon.latitude) * std::cos(longitude - moon.longitude);
}

/// Rows of data for drawing a curve, with a gap where the curve jumps from one side of the map to the other.
std::string curve_rows(const std::vector<std::pair<double, double>>& points) {
  std::string text;
  double last = points.front().second;
  for (const auto& [latitude, longitude] : points) {
    if (std::abs(longitude - last) > 180) text += "\n";
    text += fmt::format("{:.3f},{:.3f}\n", longitude, latitude);
    last = longitude;
  }
  return text;
}

/// Shade of each cell of the map (two degrees wide): 0 if nothing of the eclipse is seen, 1 for some of it, 2 for all.
std::string shade_rows(const eclipse::Eclipse& eclipse) {
  constexpr int steps = 48;  // in steps of at most 7.5 min, the Moon moves less than a map cell
  const auto& [first, last] = std::pair(*eclipse.contacts.P1, *eclipse.contacts.P4);
  std::vector<UnderMoon> moons;
  for (int i = 0; i <= steps; ++i)
    moons.push_back(
        under_moon(almanac::later(first, almanac::seconds_between(first, last) * i / steps)));
  std::string text;
  for (int latitude = -89; latitude <= 89; latitude += 2) {
    for (int longitude = -179; longitude <= 179; longitude += 2) {
      const auto seen = std::ranges::count_if(moons, [&](const UnderMoon& moon) {
        return nearness(moon, latitude * degree, longitude * degree) > std::cos(moon.reach);
      });
      const int shade = seen == 0 ? 0 : static_cast<std::size_t>(seen) == moons.size() ? 2 : 1;
      text += fmt::format("{},{},{}\n", longitude, latitude, shade);
    }
    text += "\n";
  }
  return text;
}

std::vector<PlotCurve> curves(const eclipse::Eclipse& eclipse,
                              const std::optional<almanac::Observer>& place) {
  constexpr const char* colours[] = {"#9c9c9c", "#c88a3a", "#b0432b", "#701f1f",
                                     "#b0432b", "#c88a3a", "#9c9c9c"};
  std::vector<PlotCurve> curves{
      {shade_rows(eclipse), "image"},
      {std::string(night::tables::coastlines()), "lines lc rgb '#7d8894'"}};
  const auto contacts = contacts_of(eclipse);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const auto& [name, when] = contacts[i];
    curves.push_back(
        {curve_rows(horizon_circle(when, 361)),
         fmt::format("lines lw 2 lc rgb '{}'",
                     colours[contacts.size() == 7 ? i : (i * 6) / (contacts.size() - 1)]),
         fmt::format("{} {}", name,
                     almanac::time_of_day_text(almanac::to_the_minute(when)).substr(0, 5))});
  }
  if (place)
    curves.push_back({fmt::format("{:.3f},{:.3f}\n", algebra::in_degrees(place->longitude),
                                  algebra::in_degrees(place->latitude)),
                      "points pt 7 ps 0.9 lc rgb '#d02020'"});
  return curves;
}

}  // namespace

std::vector<std::pair<double, double>> horizon_circle(const almanac::Instant& when,
                                                      std::size_t points) {
  const auto moon = under_moon(when);
  std::vector<std::pair<double, double>> circle;
  for (std::size_t i = 0; i < points; ++i) {
    const double bearing =
        2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(points - 1);
    const double sine = std::sin(moon.latitude) * std::cos(moon.reach) +
                        std::cos(moon.latitude) * std::sin(moon.reach) * std::cos(bearing);
    const double latitude = std::asin(std::clamp(sine, -1., 1.));
    const double longitude =
        moon.longitude +
        std::atan2(std::sin(bearing) * std::sin(moon.reach) * std::cos(moon.latitude),
                   std::cos(moon.reach) - std::sin(moon.latitude) * sine);
    circle.emplace_back(latitude / degree, std::remainder(longitude / degree, 360));
  }
  return circle;
}

void write_visibility_map(const std::filesystem::path& picture, const eclipse::Eclipse& eclipse,
                          const std::optional<almanac::Observer>& place) {
  require_plot_ending(picture, "a map", false);
  write_plot(
      picture,
      {.title = title(eclipse) +
                "\nwhite: all of it is seen; grey: nothing; between: a part. Along each curve "
                "the Moon is on the horizon (UTC)",
       .title_size = 14,
       .width = 1200,
       .height = 680,
       .x = {.range = {{-180, 180}}, .tic_spacing = 30, .unit = "°"},
       .panels = {{{.range = {{-90, 90}}, .tic_spacing = 30, .unit = "°"}, curves(eclipse, place)}},
       .key = "outside right top",
       .height_per_width = 0.5});
}

}  // namespace coppermoon::uses
