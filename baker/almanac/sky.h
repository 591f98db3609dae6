// SPDX-License-Identifier: MIT
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "algebra/quantity.h"
#include "almanac/instant.h"

namespace coppermoon::almanac {

/// A place on the Moon: mean-Earth/polar-axis frame, latitude north, longitude east positive.
struct SelenographicPoint {
  algebra::Angle latitude, longitude;
};

/// Where everything is, seen from the Earth's centre at one moment.
struct SkyState {
  Instant when;
  glm::dvec3 sun_m, moon_m;            ///< apparent geocentric (light time, aberration), GCRS axes [m]
  glm::dmat3 selenographic_from_gcrs;  ///< to the Moon-fixed frame: X to 0°, Y to 90° E, Z north
  glm::dmat3 equator_from_gcrs;        ///< to the true equator and equinox of date
  SelenographicPoint sub_earth, sub_solar;
  algebra::Angle axis_position_angle;  ///< of the Moon's north pole, from north of date through east
};

/// Theories of the Moon's motion: `moon98` (ERFA's; 2.9″ RMS, fast) or the full `elp_2000_82b` (libnova).
enum class LunarTheory { moon98, elp_2000_82b };

SkyState sky_at(const Instant& instant, LunarTheory theory = LunarTheory::elp_2000_82b);

/// Apparent right ascension (0 to 2π), declination and distance of a GCRS position, for the equator of date.
struct EquatorialPlace {
  algebra::Angle right_ascension, declination;
  algebra::Length distance;
};
EquatorialPlace equatorial_place(const SkyState& sky, const glm::dvec3& position_m);

}  // namespace coppermoon::almanac
