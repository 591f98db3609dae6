// SPDX-License-Identifier: MIT
#include "uses/fit/refracted_at.h"

#include <algorithm>
#include <array>
#include <numbers>

#include "algebra/interpolation.h"

namespace coppermoon::uses {
namespace {

/// Weight of a plane.
struct Share {
  std::size_t index;
  double share;
};

}  // namespace

RefractedAt::RefractedAt(const shadow::RefractedLight& light)
    : light_(light), between_places_(light), some_(light.wavelengths_nm.size()) {}

void RefractedAt::read(const eclipse::ShadowPlace& place, std::span<double> ratios) {
  const auto& depths_m = light_.arrangement.depths_m;
  const double depth_m = algebra::in_metres(place.depth),
               at_m = algebra::in_metres(place.axis_distance),
               sector = algebra::in_radians(place.position_angle) / (2 * std::numbers::pi) *
                        static_cast<double>(light_.sectors);
  const auto [nearer, farther, deeper] = algebra::on_line(depths_m, depth_m);
  const std::array planes{Share{nearer, 1 - deeper}, Share{farther, deeper}};
  std::ranges::fill(ratios, 0);
  const auto sectors = algebra::on_circle(light_.sectors, sector);
  for (std::size_t i = 0; i < sectors.at.size(); ++i)
    for (const auto& [plane, of_plane] : planes) {
      const double share = of_plane * sectors.share[i];
      if (share == 0) continue;
      between_places_.read(plane, sectors.at[i], shadow::sheared(at_m, depths_m[plane] / depth_m),
                           some_);
      for (std::size_t w = 0; w < some_.size(); ++w) ratios[w] += share * some_[w];
    }
}

}  // namespace coppermoon::uses
