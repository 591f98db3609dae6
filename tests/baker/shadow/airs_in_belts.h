// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>
#include <span>
#include <vector>

#include "atmosphere/presets.h"

namespace coppermoon::shadow {

/// Air in five belts, of each ozone under each cover; the more cover, the more dust.
inline std::vector<atmosphere::Atmosphere> airs_in_belts(std::span<const double> ozones_du,
                                                         std::span<const double> covers) {
  auto air = atmosphere::preset("undated", algebra::degrees(0));
  for (int i = 0; i < 5; ++i) air.belts.push_back({std::numbers::pi * i / 4, air.column});
  std::vector<atmosphere::Atmosphere> airs;
  for (const double ozone_du : ozones_du)
    for (const double cover : covers) {
      airs.push_back(air);
      for (auto& belt : airs.back().belts) {
        belt.column.ozone_du = ozone_du + 20 * belt.from_north_rad;
        belt.column.cloud_cover = cover;
        belt.column.dust_extinction_per_m = cover * 3e-6;
      }
    }
  return airs;
}

}  // namespace coppermoon::shadow
