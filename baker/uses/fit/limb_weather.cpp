// SPDX-License-Identifier: MIT
#include "uses/fit/limb_weather.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "atmosphere/figure.h"
#include "shadow/irradiance.h"

namespace coppermoon::uses {
namespace {

/// Ratio of refracted light to unshaded sunlight near the umbra's edge.
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

double weather_over_usual(double dimming) {
  constexpr double usual = 0.3, least = 0.5;
  return std::max(least, dimming / usual);
}

}  // namespace coppermoon::uses
