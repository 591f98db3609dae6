// SPDX-License-Identifier: MIT
#include "photons/limb.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coppermoon::photons {
namespace {

constexpr double circle = 2 * std::numbers::pi;

/// A column of air, and a position angle whose limb it stands over.
struct Seat {
  std::size_t column;
  double position_angle_rad;
};

std::vector<Seat> seats_of(const atmosphere::Atmosphere& atmosphere) {
  std::vector<Seat> seats;
  std::size_t column = 0;
  const auto add = [&](const atmosphere::Belts& belts) {
    for (const auto& belt : belts) seats.push_back({column++, belt.from_north_rad});
    if (!belts.empty()) return;
    seats.push_back({column, std::numbers::pi / 2});
    if (!atmosphere.earth.sphere()) seats.push_back({column, 0});
    ++column;
  };
  add(atmosphere.belts);
  for (const auto& region : atmosphere.regions) add(region.belts);
  return seats;
}

}  // namespace

WholeLimb::WholeLimb(const atmosphere::Atmosphere& atmosphere,
                     std::span<const atmosphere::Optics> optics, int rays)
    : atmosphere_(atmosphere) {
  const auto seats = seats_of(atmosphere);
  parts_.resize(seats.size());
  for (std::size_t i = 0; i < seats.size(); ++i)
    if (seats[i].column == first_part_.size()) first_part_.push_back(i);
  tbb::parallel_for(std::size_t{0}, parts_.size(), [&](std::size_t i) {
    const auto limb = atmosphere::limb_at(atmosphere.earth, seats[i].position_angle_rad);
    const auto& column = *atmosphere.columns()[seats[i].column];
    const LimbTable table(column, limb.curvature_radius_m, optics, rays, atmosphere.top_m());
    parts_[i] = {limb.radius_m, {}, limb.curvature_radius_m, column};
    for (const auto& o : optics) parts_[i].fans.push_back(table.fan(o));
  });
  find_borders();
}

std::array<WholeLimb::Share, 2> WholeLimb::at(double position_angle_rad) const {
  const auto [one, other] = atmosphere_.shares_at(position_angle_rad);
  const std::size_t part = first_part_[one.column];
  const bool two_seats =
      (one.column + 1 < first_part_.size() ? first_part_[one.column + 1] : parts_.size()) - part == 2;
  if (!two_seats) return {{{part, one.share}, {first_part_[other.column], other.share}}};
  const double cosine = std::cos(position_angle_rad), pole = cosine * cosine;
  return {{{part, 1 - pole}, {part + 1, pole}}};
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
    std::size_t region;
  };
  std::vector<Stretch> around;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    if (ends[i + 1] - ends[i] > 1e-12)
      around.push_back(
          {ends[i], atmosphere_.region_index((ends[i] + ends[i + 1]) / 2)});
  for (std::size_t i = 0; i < around.size(); ++i) {
    const auto& before = around[i == 0 ? around.size() - 1 : i - 1];
    if (before.region != around[i].region) borders_rad_.push_back(around[i].from_rad);
  }
}

}  // namespace coppermoon::photons
