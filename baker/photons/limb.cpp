// SPDX-License-Identifier: MIT
#include "photons/limb.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coppermoon::photons {
namespace {

constexpr double circle = 2 * std::numbers::pi;

}  // namespace

WholeLimb::WholeLimb(const atmosphere::Atmosphere& atmosphere,
                     std::span<const atmosphere::Optics> optics, int rays)
    : atmosphere_(atmosphere) {
  const auto columns = atmosphere.columns();
  const std::size_t ends = atmosphere.earth.sphere() ? 1 : 2;
  parts_.resize(columns.size() * ends);
  tbb::parallel_for(std::size_t{0}, parts_.size(), [&](std::size_t i) {
    const auto limb =
        atmosphere::limb_at(atmosphere.earth, i % ends == 0 ? std::numbers::pi / 2 : 0);
    const LimbTable table(*columns[i / ends], limb.curvature_radius_m, optics, rays,
                          atmosphere.top_m());
    parts_[i] = {limb.radius_m, {}, limb.curvature_radius_m, *columns[i / ends]};
    for (const auto& o : optics) parts_[i].fans.push_back(table.fan(o));
  });
  find_borders();
}

void WholeLimb::find_borders() {
  std::vector<double> ends{0, circle};
  for (const auto& region : atmosphere_.regions)
    for (const auto angle : {region.from, region.to})
      ends.push_back(algebra::in_radians(angle) -
                     circle * std::floor(algebra::in_radians(angle) / circle));
  std::sort(ends.begin(), ends.end());
  struct Stretch {
    double from_rad;
    std::size_t column;
  };
  std::vector<Stretch> around;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    if (ends[i + 1] - ends[i] > 1e-12)
      around.push_back({ends[i], atmosphere_.column_index((ends[i] + ends[i + 1]) / 2)});
  for (std::size_t i = 0; i < around.size(); ++i) {
    const auto& before = around[i == 0 ? around.size() - 1 : i - 1];
    if (before.column != around[i].column) borders_rad_.push_back(around[i].from_rad);
  }
}

}  // namespace coppermoon::photons
