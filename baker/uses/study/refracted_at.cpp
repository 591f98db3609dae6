// SPDX-License-Identifier: MIT
#include "uses/study/refracted_at.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "algebra/interpolation.h"

namespace coppermoon::uses {
namespace {

/// Where a place lies among planes and sectors that light is known on.
struct Between {
  std::size_t plane;
  std::array<double, 2> at_m;  ///< axis distances on that plane and the next
  double deeper;               ///< share of the next plane
  double sector;               ///< of all sectors, with its fraction
};

Between between(const eclipse::ShadowPlace& place, const std::vector<double>& depths_m,
                std::size_t sectors) {
  const double depth_m = algebra::in_metres(place.depth),
               at_m = algebra::in_metres(place.axis_distance);
  const auto above = std::ranges::upper_bound(depths_m, depth_m) - depths_m.begin();
  const auto plane = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(
      above - 1, 0, std::max<std::ptrdiff_t>(0, std::ssize(depths_m) - 2)));
  const auto next = std::min(plane + 1, depths_m.size() - 1);
  const double width = depths_m[next] - depths_m[plane];
  return {plane,
          {shadow::sheared(at_m, depths_m[plane] / depth_m),
           shadow::sheared(at_m, depths_m[next] / depth_m)},
          width > 0 ? std::clamp((depth_m - depths_m[plane]) / width, 0., 1.) : 0,
          algebra::in_radians(place.position_angle) / (2 * std::numbers::pi) *
              static_cast<double>(sectors)};
}

struct Share {
  std::size_t sector;
  double share;
};

/// The two sectors on either side, and how much each counts.
std::array<Share, 4> sectors_about(double sector, std::size_t sectors) {
  if (sectors == 1) return {{{0, 1}}};
  constexpr std::array<double, 4> nodes{-1, 0, 1, 2};
  const double before = std::floor(sector);
  const auto shares = algebra::on_polynomial(std::span(nodes), sector - before);
  std::array<Share, 4> all;
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = {(static_cast<std::size_t>(before) + sectors + i - 1) % sectors, shares[i]};
  return all;
}

}  // namespace

RefractedAt::RefractedAt(const shadow::RefractedLight& light)
    : light_(light), between_places_(light), some_(light.wavelengths_nm.size()) {}

void RefractedAt::read(const eclipse::ShadowPlace& place, std::span<double> ratios) {
  const auto where = between(place, light_.arrangement.depths_m, light_.sectors);
  std::ranges::fill(ratios, 0);
  for (const auto& [sector, of_sector] : sectors_about(where.sector, light_.sectors))
    for (const int next_plane : {0, 1}) {
      const double share = (next_plane ? where.deeper : 1 - where.deeper) * of_sector;
      if (share == 0) continue;
      between_places_.read(where.plane + static_cast<std::size_t>(next_plane), sector,
                           where.at_m[static_cast<std::size_t>(next_plane)], some_);
      for (std::size_t w = 0; w < some_.size(); ++w) ratios[w] += share * some_[w];
    }
}

}  // namespace coppermoon::uses
