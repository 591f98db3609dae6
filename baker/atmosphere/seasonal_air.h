// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "algebra/quantity.h"
#include "atmosphere/density.h"

namespace coppermoon::atmosphere {

/// One number for each of the model atmospheres of Anderson et al. (1986).
struct ByModel {
  double tropical, midlatitude_summer, midlatitude_winter, subarctic_summer, subarctic_winter;
};

/// Interpolates numbers between the model atmospheres, in latitude and season, as SeasonalAir does with temperature.
///
/// Given   year   its fractional part gives the season
/// Throws  Error  when the latitude is outside ±90°
double between_models(const ByModel& models, algebra::Angle latitude, double year);

/// Air over a latitude in a season. Temperature is interpolated between model atmospheres; density follows from
/// hydrostatic equilibrium with 1013.25 hPa at sea level.
///
///     d ln ρ/dh = −(g M / R + dT/dh) / T          g = g₀ (r₀ / (r₀ + h))²
///
/// There are models for 15° (all year), 45° and 60° (July and January, six months later in the south). Interpolation is
/// linear in latitude between 15° and 60°, and constant beyond. Over the year it follows a cosine with its extremes in
/// mid January and mid July.
///
/// Accuracy  reproduces the models' own densities to 0.7 % up to 50 km
/// Omits     weather; the polar night, which is colder than the model for 60° in winter
/// Source    Anderson et al. (1986), AFGL-TR-86-0110
class SeasonalAir {
 public:
  /// Given   year   its fractional part gives the season
  /// Throws  Error  when the latitude is outside ±90°
  SeasonalAir(algebra::Angle latitude, double year);

  /// Ratio of the density to the sea-level density of US 1976, and the slope of this ratio; both are 0 above 86 km.
  ValueAndSlope density_ratio(double altitude_m) const;

  /// Ratio of the pressure to 1013.25 hPa.
  double pressure_ratio(double altitude_m) const;

  /// Altitude at which the pressure is a given fraction of 1013.25 hPa, 0 to 86 km [m].
  double altitude_m(double pressure_ratio) const;

 private:
  /// Values at a whole kilometre of altitude: ln of the density ratio, the slope of this logarithm, temperature [K].
  struct Knot {
    double log_ratio, slope_per_m, temperature;
  };
  std::vector<Knot> knots_;
};

}  // namespace coppermoon::atmosphere
