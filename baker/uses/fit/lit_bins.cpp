// SPDX-License-Identifier: MIT
#include "uses/fit/lit_bins.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coppermoon::uses {
namespace {

using std::numbers::pi;

/// Appends a few places that represent all places in a bin. Places are grouped by distance from the shadow's axis, then
/// by position angle, and each group is replaced by its mean. Groups are at most 10 degrees wide, because light varies
/// unevenly over wider angles.
///
/// Given  middle_rad  position angle of the disc's centre, from which angles are counted
void add_groups(std::span<const LitPlace> places, double middle_rad, std::vector<LitPlace>& few) {
  constexpr std::size_t by_distance = 8;
  constexpr double widest_rad = pi / 18;
  struct Sorted {
    double distance_m, angle_rad;
    LitPlace lit;
  };
  std::vector<Sorted> all;
  for (const auto& lit : places)
    all.push_back(
        {algebra::in_metres(lit.place.axis_distance),
         std::remainder(algebra::in_radians(lit.place.position_angle) - middle_rad, 2 * pi), lit});
  std::ranges::sort(all, {}, &Sorted::distance_m);
  const auto part = [](std::span<Sorted> whole, std::size_t i, std::size_t parts) {
    const auto from = whole.size() * i / parts, to = whole.size() * (i + 1) / parts;
    return whole.subspan(from, to - from);
  };
  for (std::size_t i = 0; i < by_distance; ++i) {
    const auto ring = part(all, i, by_distance);
    if (ring.empty()) continue;
    std::ranges::sort(ring, {}, &Sorted::angle_rad);
    const auto by_angle =
        static_cast<std::size_t>(1 + (ring.back().angle_rad - ring.front().angle_rad) / widest_rad);
    for (std::size_t j = 0; j < by_angle; ++j) {
      double sunlit = 0, distance = 0, depth = 0, east = 0, north = 0, colour = 0;
      const auto group = part(ring, j, by_angle);
      for (const auto& [distance_m, angle, lit] : group) {
        sunlit += lit.sunlit;
        distance += lit.sunlit * distance_m;
        depth += lit.sunlit * algebra::in_metres(lit.place.depth);
        colour += lit.sunlit * lit.colour;
        const double angle_rad = algebra::in_radians(lit.place.position_angle);
        east += lit.sunlit * std::sin(angle_rad);
        north += lit.sunlit * std::cos(angle_rad);
      }
      if (sunlit == 0) continue;
      few.push_back({{algebra::metres(distance / sunlit),
                      algebra::within_circle(algebra::radians(std::atan2(east, north))),
                      algebra::metres(depth / sunlit)},
                     sunlit,
                     group.front().lit.bin,
                     colour / sunlit});
    }
  }
}

}  // namespace

LitBins lit_bins(const FitScene& scene, const almanac::SkyState& sky) {
  LitBins lit{scene.weights, {}, scene.bins};
  const auto axis = eclipse::shadow_axis(sky);
  std::vector<std::vector<LitPlace>> all(scene.bins);
  for (const auto& [pixel, ground, sunlit, colour, bin] : scene.grounds)
    all[bin].push_back({eclipse::place_of_ground(axis, sky, ground), sunlit, bin, colour});
  const auto middle = eclipse::place_in_shadow(axis, sky.moon_m).position_angle;
  for (const auto& of_bin : all) add_groups(of_bin, algebra::in_radians(middle), lit.places);
  return lit;
}

}  // namespace coppermoon::uses
