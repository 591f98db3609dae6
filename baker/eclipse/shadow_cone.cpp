// SPDX-License-Identifier: MIT
#include "eclipse/shadow_cone.h"

#include <cmath>
#include <numbers>

#include "algebra/error.h"
#include "almanac/ephemeris.h"

namespace coppermoon::eclipse {
namespace {

constexpr double arcsecond = std::numbers::pi / 648000;
constexpr double solar_parallax_at_1_au = 8.794148 * arcsecond;
constexpr double solar_semidiameter_at_1_au = 959.63 * arcsecond;

double distance_m(const ShadowPlace& moon) {
  return std::hypot(algebra::in_metres(moon.axis_distance), algebra::in_metres(moon.depth));
}

double lunar_parallax(const ShadowPlace& moon) {
  return std::asin(earth_radius_m / distance_m(moon));
}

/// πm and πs as the convention enlarges them, and the Sun's semidiameter likewise.
struct Enlarged {
  double parallaxes, semidiameter;
};

Enlarged enlarged(ShadowConvention convention, const ShadowAxis& axis, const ShadowPlace& moon) {
  const double sun_au = algebra::in_metres(axis.sun_distance) / almanac::astronomical_unit_m;
  const double pm = lunar_parallax(moon), ps = solar_parallax_at_1_au / sun_au,
               s = solar_semidiameter_at_1_au / sun_au;
  if (convention == ShadowConvention::danjon) return {1.01 * pm + ps, s};
  if (convention == ShadowConvention::chauvenet) return {1.02 * (0.998340 * pm + ps), 1.02 * s};
  constexpr double layer_m = 87e3;
  const double limb_m = algebra::in_metres(limb_radius(moon.position_angle, axis.sun_declination));
  return {(pm + ps) * (limb_m + layer_m) / earth_radius_m, s};
}

}  // namespace

ShadowRadii shadow_radii(ShadowConvention convention, const ShadowAxis& axis,
                         const ShadowPlace& moon) {
  const auto [parallaxes, semidiameter] = enlarged(convention, axis, moon);
  return {algebra::radians(parallaxes - semidiameter), algebra::radians(parallaxes + semidiameter)};
}

algebra::Angle lunar_semidiameter(const ShadowPlace& moon) {
  return algebra::radians(
      std::asin(lunar_radius_in_earth_radii * earth_radius_m / distance_m(moon)));
}

algebra::Length limb_radius(algebra::Angle position_angle, algebra::Angle sun_declination) {
  constexpr double eccentricity_squared = earth_flattening * (2 - earth_flattening);
  const double cos_declination = std::cos(algebra::in_radians(sun_declination));
  const double polar_squared = 1 - eccentricity_squared * cos_declination * cos_declination;
  const double sin_angle = std::sin(algebra::in_radians(position_angle)),
               cos_angle = std::cos(algebra::in_radians(position_angle));
  return algebra::metres(earth_radius_m /
                         std::sqrt(sin_angle * sin_angle + cos_angle * cos_angle / polar_squared));
}

}  // namespace coppermoon::eclipse
