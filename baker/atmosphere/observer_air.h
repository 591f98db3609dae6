// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/quantity.h"

namespace coppermoon::atmosphere {

/// The air above an observer. Ozone and aerosol are off at 0.
struct ObserverAir {
  double ozone_du = 300;               ///< vertical column, 0 to 1000 DU
  double aerosol_optical_depth = 0.1;  ///< vertical, at 550 nm, above the observer; 0 to 10
  double angstrom_exponent = 1.3;  ///< of the aerosol: its optical depth goes as λ^−this; −1 to 4
  double elevation_m = 0;          ///< of the observer above the sea, −500 to 100 000 m
};

/// A line of sight through it to a light in the sky.
struct Sightline {
  ObserverAir air;
  algebra::Angle altitude;  ///< of the light without refraction
};

/// Throws Error when a term is outside its range: names it, its unit and what is allowed.
void require_valid(const ObserverAir& air);

/// Pressure of the air at an elevation, over that at sea level.
///
///     (1 − 0.0065 h / 288.15)^5.2559 up to 11 km, from there falling by e every 6341.6 m
///
/// Given     elevation_m  h, geometric
/// Accuracy  0.3 % of US 1976 up to 11 km, 6 % up to 30 km
/// Source    U.S. Standard Atmosphere 1976; below 20 km, geometric for geopotential altitude
double pressure_ratio_us_1976(double elevation_m);

/// Optical depths of an observer's air straight up, at one wavelength.
struct VerticalDepths {
  double rayleigh, ozone, aerosol;
};

/// Throws  Error  when the air is not sound, or the wavelength is not 380 to 780 nm
VerticalDepths vertical_depths(const ObserverAir& air, algebra::Wavelength wavelength);

/// Transmittance of the observer's air for a light in the sky.
///
///     exp(−(p/p₀ M τ_R(λ) + X_O3 σ(λ) N_O3 + X_a τ_a (λ / 550 nm)^−å))
///
/// Given     air         what stands in it
///           altitude    of the light without refraction, −1 to 90 degrees; below −0.574, the
///                       apparent horizon, held as it is there
///           wavelength  380 to 780 nm
/// Returned  0 to 1: Rayleigh scattering with Young's air mass M, ozone as a layer at 22 km, aerosol
/// Omits     water vapour and oxygen lines; scattering into the line of sight; that the air masses
///           are those of sea level, and an observer above the ozone; differences across the disc
/// Throws    Error       when an argument is outside its range
double transmittance_above(const ObserverAir& air, algebra::Angle altitude,
                           algebra::Wavelength wavelength);
double transmittance_above(const VerticalDepths& depths, algebra::Angle altitude);

}  // namespace coppermoon::atmosphere
