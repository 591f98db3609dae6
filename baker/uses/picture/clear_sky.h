// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "almanac/observer.h"
#include "atmosphere/observer_air.h"
#include "atmosphere/sky_luminance.h"
#include "atmosphere/twilight_sky.h"
#include "uses/picture/scattered_colour.h"

namespace coppermoon::uses {

/// Terms of a sky's luminance [cd/m²].
struct SkyTerms {
  double airglow, twilight, moonlight;

  double sum() const { return airglow + twilight + moonlight; }
};

/// Clear sky over a place at one moment, in every direction: airglow, twilight, and moonlight that the air scatters
/// (atmosphere/twilight_sky.h, sky_luminance.h). Of a day it is that of bright twilight, with the Sun at 5 degrees.
class ClearSky {
 public:
  /// Given   moon_magnitudes  of the Moon above the air: B, V, R; infinite ones of a dark Moon
  /// Throws  Error            when a term of the air is outside its range
  ClearSky(const almanac::Observer& place, const almanac::SkyState& sky,
           const atmosphere::ObserverAir& air, std::span<const double> moon_magnitudes);
  /// The same of a Moon as white as a full one.
  ClearSky(const almanac::Observer& place, const almanac::SkyState& sky,
           const atmosphere::ObserverAir& air, double moon_magnitude);

  /// Light of the sky [cd/m²], linear Rec.709; its luminance is that of `towards`. Moonlight as the air scatters it
  /// (ScatteredColour); airglow with B − V = 1.03 and V − R = 0.74.
  ///
  /// Given   direction  as for `towards`
  /// Source  colour of airglow: Patat (2003), A&A 400, 1183
  Rgb light(const glm::dvec3& direction) const;

  /// Given  direction  unit: east, north, up; as it is seen, refraction included
  SkyTerms towards(const glm::dvec3& direction) const;

  /// Angle from the Moon, as both are seen.
  algebra::Angle from_moon(const glm::dvec3& direction) const;

  double zenith_cd_m2() const { return towards({0, 0, 1}).sum(); }
  algebra::Angle sun_altitude() const { return sun_altitude_; }  ///< airless
  algebra::Angle sun_azimuth() const { return algebra::radians(std::atan2(to_sun_.x, to_sun_.y)); }
  double extinction_mag() const { return extinction_mag_; }  ///< in V, at the zenith

 private:
  Rgb twilight_towards(const glm::dvec3& direction) const;
  double moonlight_towards(const glm::dvec3& direction) const;

  double extinction_mag_;
  atmosphere::SkyLamp moon_;
  glm::dvec3 to_moon_, to_sun_;  ///< east, north, up
  algebra::Angle sun_altitude_;
  atmosphere::TwilightSky twilight_;
  std::vector<ScatteredColour::Pair>
      of_moon_;  ///< at even altitudes from 0 to 90 degrees; empty: it is dark
};

/// Direction in an observer's sky, unit: east, north, up.
glm::dvec3 in_sky(algebra::Angle altitude, algebra::Angle azimuth);

}  // namespace coppermoon::uses
