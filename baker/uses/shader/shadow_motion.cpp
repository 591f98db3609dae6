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

/// Place of the Moon's centre [lunar radii] and rows of the rotation from Moon-fixed axes.
struct MoonInShadow {
  glm::dvec3 centre;
  glm::dmat3 rows;

  double number(std::size_t i) const {
    const auto k = static_cast<int>(i);
    return k < 3 ? centre[k] : rows[(k - 3) / 3][(k - 3) % 3];
  }
};

MoonInShadow moon_at(const almanac::Instant& when) {
  const auto sky = almanac::sky_at(when);
  const auto axis = eclipse::shadow_axis(sky);
  const double radius_m = algebra::in_metres(almanac::lunar_radius);
  return {axis.shadow_from_gcrs * sky.moon_m / radius_m,
          sky.selenographic_from_gcrs * glm::transpose(axis.shadow_from_gcrs)};
}

}  // namespace

ShadowMotion shadow_motion(const eclipse::Eclipse& eclipse) {
  const auto contacts = eclipse::contacts_of(eclipse);
  ShadowMotion motion;
  motion.half_s =
      margin_s + std::max(almanac::seconds_between(contacts.front().second, eclipse.greatest),
                          almanac::seconds_between(eclipse.greatest, contacts.back().second));
  std::vector<MoonInShadow> known;
  for (int i = 0; i < coefficients; ++i)
    known.push_back(moon_at(almanac::later(
        eclipse.greatest, motion.half_s * algebra::chebyshev_node(i, coefficients))));
  const auto series = [&](std::size_t number) {
    std::vector<double> values;
    for (const auto& moon : known) values.push_back(moon.number(number));
    return algebra::power_series(algebra::chebyshev_series(values));
  };
  for (std::size_t k = 0; k < 3; ++k) {
    motion.centre[k] = series(k);
    const auto x = series(3 + 3 * k), y = series(4 + 3 * k), z = series(5 + 3 * k);
    for (std::size_t i = 0; i < x.size(); ++i) motion.axes[k].emplace_back(x[i], y[i], z[i]);
  }
  const auto [nearest, farthest] =
      std::ranges::minmax(known, {}, [](const MoonInShadow& moon) { return moon.centre.z; });
  motion.nearest = nearest.centre.z;
  motion.farthest = farthest.centre.z;
  return motion;
}

ShadowMotion held_at(const almanac::Instant& when) {
  const auto moon = moon_at(when);
  ShadowMotion held{.half_s = margin_s, .nearest = moon.centre.z, .farthest = moon.centre.z};
  for (int k = 0; k < 3; ++k) {
    held.centre[static_cast<std::size_t>(k)] = {moon.centre[k]};
    held.axes[static_cast<std::size_t>(k)] = {moon.rows[k]};
  }
  return held;
}

}  // namespace coppermoon::uses
