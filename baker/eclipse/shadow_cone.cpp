// SPDX-License-Identifier: MIT
#include "eclipse/shadow_cone.h"

#include <cmath>
#include <numbers>

#include "almanac/ephemeris.h"
#include "atmosphere/figure.h"

namespace coppermoon::eclipse {
namespace {

constexpr double arcsecond = std::numbers::pi / 648000;
constexpr double solar_parallax_at_1_au = 8.794148 * arcsecond;
constexpr double solar_semidiameter_at_1_au = 959.63 * arcsecond;

double distance_m(const ShadowPlace& moon) {
  return std::hypot(algebra::in_metres(moon.axis_distance), algebra::in_metres(moon.depth));
}

double lunar_parallax(const ShadowPlace& moon) {
  return std::asin(atmosphere::earth_equatorial_radius_m / distance_m(moon));
}

/// Radius of the Earth's limb at the Moon's position angle, in equatorial radii of the Earth.
double limb_ratio(const ShadowAxis& axis, const ShadowPlace& moon) {
  const auto figure = atmosphere::ellipsoid(algebra::in_radians(axis.sun_declination));
  const auto limb = atmosphere::limb_at(figure, algebra::in_radians(moon.position_angle));
  return limb.radius_m / atmosphere::earth_equatorial_radius_m;
}

/// Sum πm + πs of the parallaxes, and the Sun's semidiameter, both enlarged as a shadow convention demands.
struct Enlarged {
  double parallaxes, semidiameter;
};

Enlarged enlarged(ShadowConvention convention, const ShadowAxis& axis, const ShadowPlace& moon) {
  const double sun_au = algebra::in_metres(axis.sun_distance) / almanac::astronomical_unit_m;
  const double pm = lunar_parallax(moon), ps = solar_parallax_at_1_au / sun_au,
               s = solar_semidiameter_at_1_au / sun_au;
  switch (convention) {
    case ShadowConvention::danjon:
      // FAULT Danjon's shadow 1 % of a parallax wide: 1.01 * pm => 1.02 * pm
      return {1.01 * pm + ps, s};
    case ShadowConvention::danjon_oblate:
      return {(1 + 1.0 / 85) * pm * limb_ratio(axis, moon) + ps, s};
    case ShadowConvention::chauvenet:
      return {1.02 * (0.998340 * pm + ps), 1.02 * s};
    default:
      // FAULT Herald and Sinnott's layer: layer_m = 87e3 => layer_m = 8.7e3
      constexpr double layer_m = 87e3;
      return {
          (pm + ps) * (limb_ratio(axis, moon) + layer_m / atmosphere::earth_equatorial_radius_m),
          s};
  }
}

}  // namespace

ShadowRadii shadow_radii(ShadowConvention convention, const ShadowAxis& axis,
                         const ShadowPlace& moon) {
  const auto [parallaxes, semidiameter] = enlarged(convention, axis, moon);
  return {algebra::radians(parallaxes - semidiameter), algebra::radians(parallaxes + semidiameter)};
}

algebra::Length axis_distance_at(algebra::Angle from_axis, const ShadowPlace& moon) {
  return algebra::metres(distance_m(moon) * std::sin(algebra::in_radians(from_axis)));
}

algebra::Angle lunar_semidiameter(const ShadowPlace& moon) {
  return algebra::radians(std::asin(lunar_radius_in_earth_radii *
                                    atmosphere::earth_equatorial_radius_m / distance_m(moon)));
}

}  // namespace coppermoon::eclipse
