// SPDX-License-Identifier: MIT
#include "uses/shader/shadow_motion.h"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>

#include "algebra/chebyshev.h"
#include "almanac/sky.h"
#include "eclipse/shadow_axis.h"

namespace coppermoon::uses {
namespace {

constexpr int coefficients = 5;
constexpr double margin_s = 600;

/// Twelve numbers: the position of the Moon's centre in the shadow [lunar radii], and the 3 x 3 matrix that rotates
/// Moon-fixed axes to east, north and away from the Sun.
std::vector<double> moon_at(const almanac::Instant& when) {
  const auto sky = almanac::sky_at(when);
  const auto axis = eclipse::shadow_axis(sky);
  const auto centre =
      axis.shadow_from_gcrs * sky.moon_m / algebra::in_metres(almanac::lunar_radius);
  const auto rows = sky.selenographic_from_gcrs * glm::transpose(axis.shadow_from_gcrs);
  std::vector<double> numbers{centre.x, centre.y, centre.z};
  for (int k = 0; k < 9; ++k) numbers.push_back(rows[k / 3][k % 3]);
  return numbers;
}

/// Fits power series to the Moon's positions and orientations, which are given at Chebyshev nodes in time.
ShadowMotion motion_through(const std::vector<std::vector<double>>& moons, double half_s) {
  auto series = algebra::chebyshev_series(moons);
  for (auto& one : series) one = algebra::power_series(one);
  ShadowMotion motion{.half_s = half_s, .centre = {series[0], series[1], series[2]}};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto *x = &series[3 + 3 * k], *y = x + 1, *z = y + 1;
    for (std::size_t i = 0; i < x->size(); ++i)
      motion.axes[k].emplace_back((*x)[i], (*y)[i], (*z)[i]);
  }
  const auto depth = [](const std::vector<double>& moon) { return moon[2]; };
  motion.nearest = depth(std::ranges::min(moons, {}, depth));
  motion.farthest = depth(std::ranges::max(moons, {}, depth));
  return motion;
}

}  // namespace

ShadowMotion shadow_motion(const eclipse::Eclipse& eclipse) {
  const auto contacts = eclipse::contacts_of(eclipse);
  const double half_s =
      margin_s + std::max(almanac::seconds_between(contacts.front().second, eclipse.greatest),
                          almanac::seconds_between(eclipse.greatest, contacts.back().second));
  std::vector<std::vector<double>> moons;
  for (int i = 0; i < coefficients; ++i)
    moons.push_back(moon_at(
        almanac::later(eclipse.greatest, half_s * algebra::chebyshev_node(i, coefficients))));
  return motion_through(moons, half_s);
}

ShadowMotion held_at(const almanac::Instant& when) {
  return motion_through({moon_at(when)}, margin_s);
}

}  // namespace coppermoon::uses
