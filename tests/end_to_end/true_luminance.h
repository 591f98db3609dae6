// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
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
  bool scattered = true;  ///< with light that air scatters
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

  /// Luminances of places of one depth, by increasing axis distance. In air with regions position
  /// angles are taken to the nearest degree.
  std::vector<double> at(double depth_m, std::span<const double> distances_m,
                         std::span<const double> angles_rad) const {
    const auto around = moon_.air.one_column() ? shadow::sectors_around : sectors_of_belts;
    if (moon_.air.regions.empty())
      return around_all(depth_m, distances_m, angles_rad,
                        {.rays = truth_.rays, .sectors = {around}});
    std::vector<double> all;
    for (std::size_t i = 0; i < distances_m.size(); ++i)
      all.push_back(
          around_all(depth_m, distances_m.subspan(i, 1), angles_rad.subspan(i, 1),
                     {.rays = truth_.rays, .sectors = {degrees, degree_of(angles_rad[i]), 1}})[0]);
    return all;
  }

 private:
  static constexpr std::size_t sectors_of_belts = 120, degrees = 360;

  static std::size_t degree_of(double angle_rad) {
    const auto degree = std::lround(angle_rad * 180 / std::numbers::pi);
    return static_cast<std::size_t>((degree % 360 + 360) % 360);
  }

  std::vector<double> around_all(double depth_m, std::span<const double> distances_m,
                                 std::span<const double> angles_rad,
                                 const shadow::QuadratureSettings& settings) const {
    const auto& air = moon_.air;
    const auto arrangement = arrangement_of(moon_, {depth_m});
    const auto refracted = shadow::by_quadrature(air, arrangement, waves_, distances_m, settings);
    const auto scattered = truth_.scattered
                               ? shadow::twilight(air, arrangement, twilight_nm_, distances_m)
                               : shadow::darkness(arrangement, twilight_nm_, distances_m, 1);
    const shadow::DirectLight direct(air, arrangement, waves_);
    std::vector<double> all, ratios(waves_.size()), twilight(twilight_nm_.size());
    for (std::size_t d = 0; d < distances_m.size(); ++d) {
      direct.ratios(distances_m[d], angles_rad[d], depth_m, ratios);
      std::ranges::fill(twilight, 0);
      add_at(scattered, d, angles_rad[d], twilight);
      for (std::size_t w = 0; w < waves_.size(); ++w)
        ratios[w] += algebra::interpolated(twilight_nm_, twilight, waves_[w]);
      if (settings.sectors.count == 1)
        add(refracted.ratio[settings.sectors.first].row(d), 1, ratios);
      else
        add_at(refracted, d, angles_rad[d], ratios);
      double sum = 0;
      for (std::size_t w = 0; w < waves_.size(); ++w) sum += weights_(0, w) * ratios[w];
      all.push_back(sum);
    }
    return all;
  }

  /// Adds the light of one distance at a position angle.
  static void add_at(const shadow::RefractedLight& light, std::size_t distance, double angle_rad,
                     std::vector<double>& ratios) {
    for (std::size_t s = 0; s < light.sectors; ++s)
      add(light.ratio[s].row(distance), share(s, light.sectors, angle_rad), ratios);
  }

  static void add(std::span<const double> row, double share, std::vector<double>& ratios) {
    for (std::size_t w = 0; w < ratios.size(); ++w) ratios[w] += share * row[w];
  }

  /// Share of a sector in the sum of waves around the axis that goes through all of them: what an
  /// ellipsoid does is one, cos 2θ; belts make 48 at most.
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
