// SPDX-License-Identifier: MIT
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "algebra/quantity.h"
#include "almanac/sky.h"

namespace coppermoon::eclipse {

/// The line from the Sun's centre through the Earth's centre, and the shadow frame, which is right-handed and has its
/// origin at the Earth's centre: X points to celestial east, Y to celestial north, Z away from the Sun. East and north
/// are directions in the sky at the shadow, as seen from the Earth.
struct ShadowAxis {
  glm::dmat3 shadow_from_gcrs;
  algebra::Length sun_distance;
  algebra::Angle sun_declination =
      {};  ///< Sun's apparent declination of date: the tilt of the Earth's poles towards the axis
};

/// Accuracy  0.1″, or 0.2 km at the Moon, from 1800 to 2100, as for almanac::apparent_sun_m
ShadowAxis shadow_axis(const almanac::SkyState& sky);

/// Computes the shadow axis from the apparent position of the Sun alone.
///
/// Given  sun_m           apparent geocentric position, GCRS axes [m]
///        celestial_pole  unit vector to the celestial pole of date, GCRS axes
ShadowAxis shadow_axis(const glm::dvec3& sun_m, const glm::dvec3& celestial_pole);

/// Position of a point in the shadow frame, in cylindrical coordinates.
struct ShadowPlace {
  algebra::Length axis_distance;  ///< distance from the shadow axis
  algebra::Angle position_angle;  ///< around the axis, from celestial north through east, 0 to 2π
  algebra::Length depth;          ///< distance behind the Earth along the axis, negative sunward
};

/// Given  position_m  geocentric position, GCRS axes [m]
ShadowPlace place_in_shadow(const ShadowAxis& axis, const glm::dvec3& position_m);

ShadowPlace moon_in_shadow(const almanac::SkyState& sky);

/// Position, in the shadow, of a place on the Moon's surface.
///
/// Given  ground  unit vector from the Moon's centre to the place, Moon-fixed axes
ShadowPlace place_of_ground(const ShadowAxis& axis, const almanac::SkyState& sky,
                            const glm::dvec3& ground);

}  // namespace coppermoon::eclipse
