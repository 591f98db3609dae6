// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "algebra/interpolation.h"
#include "shadow/twilight.h"
#include "uses/light/planning.h"
#include "uses/light/spectral_bands.h"

namespace coppermoon::end_to_end {

/// How finely the truth is computed.
struct Truth {
  int bands = 400, rays = 2000;
};

/// Luminance of neutral ground on the Moon that faces the Sun, each place on a plane of its own: all
/// terms, no look-up, nothing between planes, places or sectors but where the Earth is an ellipsoid.
class TrueLuminance {
 public:
  TrueLuminance(uses::ShadowedMoon moon, const Truth& truth)
      : moon_(std::move(moon)),
        truth_(truth),
        waves_(uses::wavelengths_nm(truth.bands)),
        weights_(uses::at_wavelengths(uses::luminance_weights(), truth.bands)) {
    for (double nm = 380; nm <= 780; nm += 5) twilight_nm_.push_back(nm);
  }

  /// Luminances of places of one depth, by increasing axis distance. Air with regions is turned
  /// until the place's position angle is that of a sector, which only a sphere allows.
  std::vector<double> at(double depth_m, std::span<const double> distances_m,
                         std::span<const double> angles_rad) const {
    if (moon_.air.regions.empty()) return around(moon_.air, depth_m, distances_m, angles_rad);
    std::vector<double> all;
    for (std::size_t i = 0; i < distances_m.size(); ++i) {
      auto air = moon_.air;
      for (auto& region : air.regions)
        for (auto* angle : {&region.from, &region.to})
          *angle = algebra::radians(algebra::in_radians(*angle) - angles_rad[i]);
      const double north = 0;
      all.push_back(around(air, depth_m, distances_m.subspan(i, 1), {&north, 1})[0]);
    }
    return all;
  }

 private:
  std::vector<double> around(const atmosphere::Atmosphere& air, double depth_m,
                             std::span<const double> distances_m,
                             std::span<const double> angles_rad) const {
    const shadow::Arrangement arrangement{moon_.sun_distance_m, {depth_m}, moon_.limb_darkening};
    const bool one_sector = !air.regions.empty();
    const auto refracted = shadow::by_quadrature(
        air, arrangement, waves_, distances_m,
        {.rays = truth_.rays, .sectors = one_sector ? 1 : shadow::sectors_around});
    const auto scattered = shadow::twilight(air, arrangement, twilight_nm_, distances_m);
    const shadow::DirectLight direct(air, arrangement, waves_);
    std::vector<double> all, ratios(waves_.size());
    for (std::size_t d = 0; d < distances_m.size(); ++d) {
      direct.ratios(distances_m[d], angles_rad[d], depth_m, ratios);
      for (std::size_t w = 0; w < waves_.size(); ++w)
        ratios[w] += algebra::interpolated(twilight_nm_, scattered.ratio[0].row(d), waves_[w]);
      const std::size_t sectors = one_sector ? 1 : refracted.sectors;
      for (std::size_t s = 0; s < sectors; ++s)
        add(refracted.ratio[s].row(d), share(s, sectors, angles_rad[d]), ratios);
      double sum = 0;
      for (std::size_t w = 0; w < waves_.size(); ++w) sum += weights_(0, w) * ratios[w];
      all.push_back(sum);
    }
    return all;
  }

  static void add(std::span<const double> row, double share, std::vector<double>& ratios) {
    for (std::size_t w = 0; w < ratios.size(); ++w) ratios[w] += share * row[w];
  }

  /// Share of a sector in the sum of waves around the axis that goes through all of them: what an
  /// ellipsoid does has one, cos 2θ.
  static double share(std::size_t sector, std::size_t sectors, double angle_rad) {
    if (sectors == 1) return 1;
    const auto count = static_cast<double>(sectors);
    const double half = angle_rad / 2 - std::numbers::pi * static_cast<double>(sector) / count;
    return std::abs(std::sin(half)) < 1e-9 ? 1 : std::sin(count * half) / std::tan(half) / count;
  }

  uses::ShadowedMoon moon_;
  Truth truth_;
  std::vector<double> waves_, twilight_nm_;
  algebra::Grid<double> weights_;
};

}  // namespace coppermoon::end_to_end
