// SPDX-License-Identifier: MIT
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "algebra/quantity.h"
#include "almanac/ephemeris.h"
#include "almanac/instant.h"
#include "almanac/lunar_orientation.h"

namespace coppermoon::almanac {

/// Where everything is, seen from the Earth's centre at one moment.
struct SkyState {
  Instant when;
  glm::dvec3 sun_m, moon_m;  ///< apparent geocentric (light time, aberration), GCRS axes [m]
  glm::dmat3 selenographic_from_gcrs;  ///< to the Moon-fixed frame: X to 0°, Y to 90° E, Z north
  glm::dmat3 equator_from_gcrs;        ///< to the true equator and equinox of date
  SelenographicPoint sub_earth, sub_solar;  ///< as light meets the moving Moon: aberration included
  algebra::Angle
      axis_position_angle;  ///< of the Moon's north pole, from north of date through east
};

/// The sky at a moment, by one of the two lunar theories (ephemeris.h).
///
/// Accuracy  Moon 1 km, libration, sub-solar point and axis 0.01° against DE431, 2007 to 2010;
///           tables that leave aberration out of the libration differ by 20.5″, 0.0057°
/// Source    precession and nutation: IAU 2006/2000A (ERFA eraPnm06a)
SkyState sky_at(const Instant& instant, LunarTheory theory = LunarTheory::elp_2000_82b);

/// Apparent right ascension (0 to 2π), declination and distance of a GCRS position, for the equator
/// of date.
struct EquatorialPlace {
  algebra::Angle right_ascension, declination;
  algebra::Length distance;
};
EquatorialPlace equatorial_place(const SkyState& sky, const glm::dvec3& position_m);

/// True equator and equinox of date from GCRS axes. The bottom row is the celestial pole of date.
glm::dmat3 equator_from_gcrs(const Instant& instant);

/// The angle at `direction` on the sky from north through east to `target`, −π to π.
///
/// Given   direction   where one looks, any length, all in the same axes
///         target      the direction pointed to, any length
///         north       the celestial pole, a unit vector
algebra::Angle position_angle(const glm::dvec3& direction, const glm::dvec3& target,
                              const glm::dvec3& north);

}  // namespace coppermoon::almanac
