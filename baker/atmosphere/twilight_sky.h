// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "algebra/quantity.h"
#include "atmosphere/observer_air.h"

namespace coppermoon::atmosphere {

/// Light of a clear twilight sky in every direction: sunlight scattered any number of times in a spherical atmosphere.
///
/// Interpolates the logarithms in twilight_sky.csv by the Sun's altitude and the observer's aerosol, ozone and
/// elevation. The table ends with the Sun at -16 degrees. Below, the light in all directions continues to fall at the
/// same rate: the mean rate of the sky's light just above -16 degrees.
///
/// Given     sun_altitude  of the Sun's centre, airless; -90 to 5 degrees
/// Accuracy  of the light: a quarter with the Sun down to -6 degrees, a third with the Sun at -12 degrees; the zenith
///           is 0.2 to 0.5 mag darker than measured on Paranal
/// Omits     refraction, polarisation, aerosol in the stratosphere; light from the mesosphere
/// Throws    Error         when the Sun's altitude or a quantity of the air is outside its range
/// Source    data/make_twilight_sky.py
class TwilightSky {
 public:
  TwilightSky(algebra::Angle sun_altitude, const ObserverAir& air);

  /// Light from a direction in the sky [cd/m²], linear Rec.709.
  ///
  /// Given  altitude  0 to 90 degrees; values outside are clamped
  ///        aside     azimuth relative to the Sun's
  std::array<double, 3> towards(algebra::Angle altitude, algebra::Angle aside) const;

 private:
  std::vector<std::array<float, 3>> light_;  ///< as [altitude][azimuth], in even steps
};

}  // namespace coppermoon::atmosphere
