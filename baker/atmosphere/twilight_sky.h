// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "algebra/quantity.h"
#include "atmosphere/observer_air.h"

namespace coppermoon::atmosphere {

/// Twilight of a clear sky in every direction: sunlight scattered any number of times by spherical air.
///
/// Interpolates the logarithms in twilight_sky.csv by the Sun's altitude and by the observer's aerosol, ozone and
/// elevation. Below the table's last altitude, -16 degrees, the mean slope there continues.
///
/// Given     sun_altitude  of the Sun's centre, airless; -90 to 5 degrees
/// Accuracy  a quarter down to a Sun at -6 degrees, a third at -12; the zenith is 0.2 to 0.5 mag darker than measured
///           on Paranal
/// Omits     refraction, polarisation, aerosol in the stratosphere; light from the mesosphere
/// Throws    Error         when the Sun's altitude or a term of the air is outside its range
/// Source    data/make_twilight_sky.py
class TwilightSky {
 public:
  TwilightSky(algebra::Angle sun_altitude, const ObserverAir& air);

  /// Light in a direction [cd/m²], linear Rec.709.
  ///
  /// Given  altitude  0 to 90 degrees; held at either end
  ///        aside     azimuth relative to the Sun's
  std::array<double, 3> towards(algebra::Angle altitude, algebra::Angle aside) const;

 private:
  std::vector<std::array<float, 3>> light_;  ///< [altitude][azimuth], in even steps
};

}  // namespace coppermoon::atmosphere
