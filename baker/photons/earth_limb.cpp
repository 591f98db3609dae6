// SPDX-License-Identifier: MIT
#include "photons/earth_limb.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <utility>

#include "algebra/quadrature.h"

namespace coppermoon::photons {
namespace {

/// A column of air, and a position angle of the limb at which this column lies.
struct Seat {
  std::size_t column;
  double position_angle_rad;
};

std::vector<Seat> seats_of(const atmosphere::Atmosphere& atmosphere) {
  std::vector<Seat> all;
  std::size_t column = 0;
  const auto add = [&](const atmosphere::Belts& belts) {
    for (const auto& belt : belts) all.push_back({column++, belt.from_north_rad});
    if (!belts.empty()) return;
    all.push_back({column, std::numbers::pi / 2});
    if (!atmosphere.earth.sphere()) all.push_back({column, 0});
    ++column;
  };
  add(atmosphere.belts);
  for (const auto& region : atmosphere.regions) add(region.belts);
  const auto used = atmosphere.columns_in_use();
  std::erase_if(all, [&](const Seat& seat) { return !used[seat.column]; });
  return all;
}

/// Gauss nodes between two position angles, to integrate a smooth function times harmonics up to `highest`.
std::vector<algebra::QuadratureNode> nodes_between(double from, double to, int highest) {
  constexpr int count = 16;
  constexpr double phase = 8;  // largest phase [rad] of a harmonic within one piece
  const double pieces = std::ceil((to - from) * (highest + 2) / phase),
               half = (to - from) / pieces / 2;
  std::vector<algebra::QuadratureNode> all;
  for (double piece = 0; piece < pieces; ++piece)
    for (const auto& node : algebra::gauss_legendre(count))
      all.push_back({from + half * (2 * piece + 1 + node.x), half * node.weight});
  return all;
}

/// Sets coefficients to 0 if they are rounding errors, and drops the highest harmonics if they are 0 in all series.
void drop_negligible(std::vector<WholeLimb::Series>& all) {
  constexpr double negligible = 1e-12;
  std::size_t count = 1;
  for (auto& [cosine, sine] : all)
    for (auto* row : {&cosine, &sine})
      for (std::size_t m = 0; m < row->size(); ++m) {
        double& value = (*row)[m];
        if (std::abs(value) < negligible)
          value = 0;
        else
          count = std::max(count, m + 1);
      }
  for (auto& [cosine, sine] : all) {
    cosine.resize(count);
    sine.resize(count);
  }
}

}  // namespace

std::size_t parts_of_limb(const atmosphere::Atmosphere& atmosphere) {
  return seats_of(atmosphere).size();
}

WholeLimb::WholeLimb(const atmosphere::Atmosphere& atmosphere,
                     std::span<const atmosphere::Optics> optics, int rays, Fans fans)
    : atmosphere_(atmosphere) {
  const auto seats = seats_of(atmosphere);
  parts_.resize(seats.size());
  part_of_column_.resize(atmosphere.columns().size());
  for (std::size_t i = seats.size(); i-- > 0;) part_of_column_[seats[i].column] = i;
  std::vector<std::optional<LimbTable>> tables(parts_.size());
  tbb::parallel_for(std::size_t{0}, parts_.size(), [&](std::size_t i) {
    const auto limb = atmosphere::limb_at(atmosphere.earth, seats[i].position_angle_rad);
    const auto& column = *atmosphere.columns()[seats[i].column];
    tables[i].emplace(column, limb.curvature_radius_m, optics, rays, atmosphere.top_m());
    parts_[i] = {limb.radius_m, {}, limb.curvature_radius_m, column, seats[i].column};
    if (fans == Fans::when_asked) return;
    for (const auto& o : optics) parts_[i].fans.push_back(tables[i]->fan(o, column));
  });
  if (fans == Fans::when_asked)
    for (auto& table : tables) tables_.push_back(std::move(*table));
}

std::array<WholeLimb::Share, 2> WholeLimb::at(double position_angle_rad) const {
  const auto [one, other] = atmosphere_.shares_at(position_angle_rad);
  const std::size_t part = part_of_column_[one.column];
  const bool two_seats =
      part + 1 < parts_.size() && parts_[part + 1].column_index == parts_[part].column_index;
  if (!two_seats) return {{{part, one.share}, {part_of_column_[other.column], other.share}}};
  const double cosine = std::cos(position_angle_rad), pole = cosine * cosine;
  // FAULT pole and equator exchanged: 1 - pole}, {part + 1, pole} => pole}, {part + 1, 1 - pole}
  return {{{part, 1 - pole}, {part + 1, pole}}};
}

std::vector<WholeLimb::Series> WholeLimb::series(int highest) const {
  const auto count = static_cast<std::size_t>(highest) + 1;
  const std::vector<double> none(count);
  std::vector<Series> all(parts_.size(), {none, none});
  const auto ends = atmosphere_.seams_rad();
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    for (const auto& node : nodes_between(ends[i], ends[i + 1], highest)) {
      const auto turn = std::polar(1., node.x);
      for (const auto& [part, share] : at(node.x)) {
        std::complex<double> turned = share * node.weight / std::numbers::pi;
        for (std::size_t m = 0; share != 0 && m < count; ++m, turned *= turn) {
          // FAULT the mean over position angles twice: (m == 0 ? 0.5 : 1) => 1
          all[part].cosine[m] += (m == 0 ? 0.5 : 1) * turned.real();
          all[part].sine[m] += turned.imag();
        }
      }
    }
  drop_negligible(all);
  return all;
}

}  // namespace coppermoon::photons
