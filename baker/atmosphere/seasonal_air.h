// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "algebra/quantity.h"
#include "atmosphere/density.h"

namespace coppermoon::atmosphere {

/// Air over a latitude in a season: its temperature that of model atmospheres between which it lies,
/// its density what a column at rest has of it over 1013.25 hPa.
///
///     d ln ρ/dh = −(g M / R + dT/dh) / T          g = g₀ (r₀ / (r₀ + h))²
///
/// Models stand at 15° (all year), 45° and 60° (July and January, six months later in the south);
/// between them latitudes are straight, seasons a cosine with its crests in mid January and July;
/// beyond 15° and 60° they are held.
///
/// Accuracy  the models' own densities to 0.7 % up to 50 km
/// Omits     weather; the polar night, colder than 60° in winter
/// Source    Anderson et al. (1986), AFGL-TR-86-0110
class SeasonalAir {
 public:
  /// Given   year   with its fraction, which is the season
  /// Throws  Error  when the latitude is outside ±90°
  SeasonalAir(algebra::Angle latitude, double year);

  /// ρ over the sea-level density of US 1976, and its slope; 0 above 86 km.
  ValueAndSlope density_ratio(double altitude_m) const;

  /// Pressure over 1013.25 hPa.
  double pressure_ratio(double altitude_m) const;

  /// The altitude of a pressure, 0 to 86 km [m].
  double altitude_m(double pressure_ratio) const;

 private:
  /// At whole kilometres.
  struct Knot {
    double log_ratio, slope_per_m, temperature;
  };
  std::vector<Knot> knots_;
};

}  // namespace coppermoon::atmosphere
