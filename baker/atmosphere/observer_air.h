// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/quantity.h"

namespace coppermoon::atmosphere {

/// Air above an observer. A value of 0 switches ozone or aerosol off.
struct ObserverAir {
  double ozone_du = 300;               ///< vertical column of ozone, 0 to 1000 DU
  double aerosol_optical_depth = 0.1;  ///< vertical, at 550 nm, above the observer; 0 to 10
  double angstrom_exponent = 1.3;      ///< å, −1 to 4: optical depth is proportional to λ^−å
  double elevation_m = 0;              ///< elevation of the observer, −500 to 100 000 m
};

/// Line of sight through an observer's air.
struct Sightline {
  ObserverAir air;
  algebra::Angle altitude;  ///< true (airless) altitude of the observed body
};

/// Throws an Error when a quantity is outside its range. The message gives the quantity's name, unit and range.
void require_valid(const ObserverAir& air);

/// Ratio of the air pressure at an elevation to that at sea level.
///
///     (1 − 0.0065 h / 288.15)^5.2559 up to 11 km; above, it falls by a factor of e every 6341.6 m
///
/// Given     elevation_m  h, geometric
/// Accuracy  0.3 % compared with US 1976 up to 11 km, 6 % up to 30 km
/// Source    U.S. Standard Atmosphere 1976: formulae below 20 km, with geometric instead of geopotential altitude
double pressure_ratio_us_1976(double elevation_m);

/// Vertical optical depths of an observer's air at one wavelength.
struct VerticalDepths {
  double rayleigh, ozone, aerosol;
};

/// Throws an Error when a quantity of the air is outside its range, or the wavelength is outside 380 to 780 nm.
VerticalDepths vertical_depths(const ObserverAir& air, algebra::Wavelength wavelength);

/// Transmittance of the observer's air along a line of sight.
///
///     exp(−(p/p₀ M τ_R(λ) + X_O3 σ(λ) N_O3 + X_a τ_a (λ / 550 nm)^−å))
///
/// Given     altitude    true (airless), −1 to 90 degrees; values below the apparent horizon, −0.574, count as −0.574
///           wavelength  380 to 780 nm
/// Returned  0 to 1; the terms are for Rayleigh scattering (Young's air mass M), ozone (a layer at 22 km) and aerosol
/// Omits     lines of water vapour and oxygen; scattering into the line of sight; change of the air masses with
///           elevation; the case of an observer above the ozone; differences across the Moon's disc
/// Throws    Error       when an argument is outside its range
double transmittance_above(const ObserverAir& air, algebra::Angle altitude,
                           algebra::Wavelength wavelength);
double transmittance_above(const VerticalDepths& depths, algebra::Angle altitude);

}  // namespace coppermoon::atmosphere
