// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/quantity.h"

namespace coppermoon::atmosphere {

/// Molecules in a cubic metre of air at sea level, 15 °C, 1013.25 hPa [m⁻³].
///
/// Source  U.S. Standard Atmosphere 1976
inline constexpr double sea_level_number_density_per_m3 = 2.546972e25;

/// Rayleigh scattering cross-section of a molecule of air.
///
///     σ = 24 π³ (n² − 1)² F / (λ⁴ N² (n² + 2)²),     F = 1.050
///
/// Given     wavelength  380 to 780 nm
///           n − 1       sea_level_refractivity_crc, N the sea-level number density
/// Returned  σ [m²]      4.491e-31 at 550 nm
/// Accuracy  0.81 % (380 nm) to 0.01 % (780 nm) below Bucholtz (1995), whose F varies
/// Throws    Error       when the wavelength is outside its range
/// Source    Bucholtz (1995), Appl. Opt. 34, 2765, Eq. 2; F fixed as in Yapo & Cutler (2009) §2.5
double rayleigh_cross_section_m2(algebra::Wavelength wavelength);

}  // namespace coppermoon::atmosphere
