// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

#include "almanac/sky.h"

namespace coppermoon::almanac {

/// A place on the Earth: geodetic WGS 84 latitude, longitude east positive, height above the ellipsoid.
struct Observer {
  algebra::Angle latitude, longitude;
  algebra::Length elevation;
};

/// How an observer sees the Moon without the air.
struct ObserverView {
  glm::dvec3 position_m;             ///< the observer, geocentric, GCRS axes
  glm::dvec3 zenith;                 ///< unit, GCRS axes (geodetic vertical)
  glm::dvec3 north;                  ///< unit, GCRS axes: the celestial pole of date
  algebra::Angle altitude, azimuth;  ///< of the Moon's centre; azimuth from north through east
  algebra::Angle
      parallactic_angle;          ///< at the Moon, from celestial north to the zenith, through east
  algebra::Length moon_distance;  ///< observer to the Moon's centre
  SelenographicPoint sub_observer;  ///< topocentric libration
};

/// Throws  Error  if the latitude is outside ±90°, the longitude ±360° or the elevation −500 to 100 000 m
void require_on_earth(const Observer& observer);

/// The Moon as seen from a place on the Earth, without refraction.
///
/// Omits   polar motion (0.6″), diurnal aberration (0.3″), UT1 − UTC (0.9 s, 14″ of azimuth)
/// Throws  Error  like require_on_earth
ObserverView view_from(const Observer& observer, const SkyState& sky);

}  // namespace coppermoon::almanac
