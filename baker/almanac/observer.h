// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

#include "almanac/sky.h"

namespace coppermoon::almanac {

/// A place on the Earth: geodetic latitude (WGS 84), longitude (positive east) and elevation above the ellipsoid.
struct Observer {
  algebra::Angle latitude, longitude;
  algebra::Length elevation;
};

/// How an observer would see the Moon if there were no air.
struct ObserverView {
  glm::dvec3 position_m;             ///< from the Earth's centre to the observer, in GCRS axes
  glm::dvec3 zenith;                 ///< unit vector along the geodetic vertical, in GCRS axes
  glm::dvec3 north;                  ///< unit vector to the celestial pole of date, in GCRS axes
  algebra::Angle altitude, azimuth;  ///< of the Moon's centre; azimuth is from north through east
  algebra::Angle
      parallactic_angle;          ///< angle at the Moon from celestial north through east to zenith
  algebra::Length moon_distance;  ///< from the observer to the Moon's centre
  SelenographicPoint sub_observer;  ///< the place in the middle of the disc (topocentric libration)
};

/// Throws an Error unless latitude is within ±90°, longitude within ±360° and elevation within −500 to 100 000 m.
void require_on_earth(const Observer& observer);

/// The Moon as seen from a place on the Earth, without refraction.
///
/// Omits   polar motion (0.6″), diurnal aberration (0.3″), UT1 − UTC (0.9 s, or 14″ in azimuth)
/// Throws  Error  in the same cases as require_on_earth
ObserverView view_from(const Observer& observer, const SkyState& sky);

}  // namespace coppermoon::almanac
