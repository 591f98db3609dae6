// SPDX-License-Identifier: MIT
#include "uses/fit/limb_weather.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>

#include "atmosphere/figure.h"
#include "shadow/irradiance.h"

namespace coppermoon::uses {
namespace {

/// Ratio of refracted light to full sunlight near the umbra's edge.
constexpr double refracted_at_the_edge = 3e-4;

}  // namespace

std::array<double, weather_sectors> shares_of_limb(const eclipse::ShadowPlace& place,
                                                   double sun_distance_m) {
  constexpr double brighter_m = 0.7e6, step_rad = std::numbers::pi / 36;
  constexpr int steps = 72;
  const double depth_m = algebra::in_metres(place.depth),
               distance_m = algebra::in_metres(place.axis_distance),
               image_m = shadow::projected_solar_radius_m({sun_distance_m, {depth_m}}, depth_m),
               edge_m = atmosphere::earth_equatorial_radius_m * (1 + depth_m / sun_distance_m);
  std::array<double, weather_sectors> shares{};
  for (int i = 0; i < steps; ++i) {
    const double angle = i * step_rad - algebra::in_radians(place.position_angle),
                 along = distance_m * std::cos(angle), beside = distance_m * std::sin(angle);
    if (std::abs(beside) >= image_m) continue;
    const double half = std::sqrt(image_m * image_m - beside * beside);
    const double from = std::min(along - half, edge_m), to = std::min(along + half, edge_m);
    const double light = std::exp(to / brighter_m) - std::exp(from / brighter_m);
    constexpr int a_sector = steps / static_cast<int>(weather_sectors);
    shares[static_cast<std::size_t>((i + a_sector / 2) / a_sector) % weather_sectors] += light;
  }
  const double direct = 1 - shadow::covered_part(distance_m, depth_m, sun_distance_m,
                                                 atmosphere::earth_equatorial_radius_m),
               sum = std::reduce(shares.begin(), shares.end()),
               refracted = refracted_at_the_edge / (refracted_at_the_edge + direct);
  for (double& share : shares) share *= sum > 0 ? refracted / sum : 0;
  return shares;
}

algebra::Grid<double> limb_of_bins(const FitScene& scene) {
  const double sun_m = glm::length(scene.sky.sun_m);
  algebra::Grid<double> shares(scene.bins, weather_sectors);
  std::vector<double> sunlit(scene.bins);
  for (const auto& lit : lit_bins(scene, scene.sky).places) {
    const auto of_place = shares_of_limb(lit.place, sun_m);
    sunlit[lit.bin] += lit.sunlit;
    for (std::size_t s = 0; s < of_place.size(); ++s)
      shares(lit.bin, s) += lit.sunlit * of_place[s];
  }
  for (std::size_t b = 0; b < scene.bins; ++b)
    for (double& share : shares.row(b)) share /= std::max(sunlit[b], 1e-300);
  return shares;
}

double light_by_weather(std::size_t kind, std::size_t channel, double distance_km) {
  constexpr std::array<double, 3> all{1, 1.2, 1.4}, blue{0, 0.3, 0.6};
  constexpr double umbra_km = 4600;
  if (kind == weather_of_blue) return blue[channel];
  return all[channel] *
         (kind == weather_of_light ? 1 : 1 - 2 * std::min(1., distance_km / umbra_km));
}

algebra::Grid<double> weather_changes(std::span<const double> seconds) {
  constexpr double hour_s = 3600, least_hours = 0.25, stays = 0.8;
  const auto [first, last] = std::ranges::minmax(seconds);
  const double hours = (last - first) / hour_s;
  const auto count = hours < least_hours ? 1 : static_cast<std::size_t>(std::ceil(hours)) + 1;
  const auto left_at = [&](std::size_t hour, std::size_t change) {
    if (change > hour) return 0.;
    return (change == 0 ? 1 : std::sqrt(1 - stays * stays)) *
           std::pow(stays, static_cast<double>(hour - change));
  };
  algebra::Grid<double> weights(seconds.size(), count);
  for (std::size_t i = 0; i < seconds.size(); ++i) {
    const double place = count > 1 ? (seconds[i] - first) / hour_s : 0;
    const auto hour = std::min(static_cast<std::size_t>(place), count - 1);
    const double part = place - static_cast<double>(hour);
    for (std::size_t change = 0; change < count; ++change)
      weights(i, change) =
          (1 - part) * left_at(hour, change) + (part > 0 ? part * left_at(hour + 1, change) : 0);
  }
  return weights;
}

double weather_over_usual(double dimming) {
  constexpr double usual = 0.3, least = 0.5;
  return std::max(least, dimming / usual);
}

}  // namespace coppermoon::uses
