// SPDX-License-Identifier: MIT
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "algebra/quantity.h"
#include "almanac/ephemeris.h"
#include "almanac/instant.h"
#include "almanac/lunar_orientation.h"

namespace coppermoon::almanac {

/// Geocentric positions and orientations of the Sun and the Moon at one moment.
struct SkyState {
  Instant when;
  glm::dvec3 sun_m, moon_m;  ///< apparent positions from the Earth's centre, in GCRS axes [m]
  glm::dmat3 selenographic_from_gcrs;  ///< rotation to Moon-fixed axes: X 0°, Y 90° E, Z north
  glm::dmat3 equator_from_gcrs;        ///< rotation to the true equator and equinox of date
  SelenographicPoint sub_earth, sub_solar;  ///< where Earth and Sun are overhead, with aberration
  algebra::Angle
      axis_position_angle;  ///< position angle of the Moon's north pole, from celestial north through east
};

/// Computes positions and orientations at a moment with one of the two lunar theories (ephemeris.h).
///
/// Accuracy  compared with DE431 from 2007 to 2010, 1 km for the Moon's position, and 0.01° for libration, sub-solar
///           point and axis. Published librations that neglect aberration differ by 20.5″, or 0.0057°
/// Source    precession and nutation: IAU 2006/2000A (ERFA eraPnm06a)
SkyState sky_at(const Instant& instant, LunarTheory theory = LunarTheory::elp_2000_82b);

/// Apparent right ascension (0 to 2π), declination and distance, relative to the true equator and equinox of date.
struct EquatorialPlace {
  algebra::Angle right_ascension, declination;
  algebra::Length distance;
};
EquatorialPlace equatorial_place(const SkyState& sky, const glm::dvec3& position_m);

/// The rotation from GCRS axes to the true equator and equinox of date. Its bottom row is the celestial pole of date.
glm::dmat3 equator_from_gcrs(const Instant& instant);

/// Position angle of `target` as seen at `direction`, from north through east, −π to π.
///
/// Given   direction   vector to the vertex of the angle, of any length; all vectors are in the same axes
///         target      vector of any length
///         north       unit vector to the celestial pole
algebra::Angle position_angle(const glm::dvec3& direction, const glm::dvec3& target,
                              const glm::dvec3& north);

}  // namespace coppermoon::almanac
