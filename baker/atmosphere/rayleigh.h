// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/quantity.h"

namespace coppermoon::atmosphere {

/// Number density of air at sea level, 15 °C, 1013.25 hPa [m⁻³].
///
/// Source  U.S. Standard Atmosphere 1976
inline constexpr double sea_level_number_density_per_m3 = 2.546972e25;

/// Rayleigh scattering cross-section of a molecule of air.
///
///     σ = 24 π³ (n² − 1)² F / (λ⁴ N² (n² + 2)²),     F = 1.050
///
/// Given     wavelength  380 to 780 nm
///           n − 1       from sea_level_refractivity_crc; N is the sea-level number density
/// Returned  σ [m²]      4.491e-31 at 550 nm
/// Accuracy  lower than Bucholtz (1995), whose F depends on wavelength, by 0.81 % at 380 nm and 0.01 % at 780 nm
/// Throws    Error       when the wavelength is outside its range
/// Source    Bucholtz (1995), Appl. Opt. 34, 2765, Eq. 2; F fixed as in Yapo & Cutler (2009) §2.5
double rayleigh_cross_section_m2(algebra::Wavelength wavelength);

/// Rayleigh scattering cross-section [m²] for any refractivity n − 1 at sea level and any King factor F.
///
/// Accuracy  with sea_level_refractivity_ciddor_1996 and king_factor_bates_1984, 0.03 to 0.13 % higher than Bucholtz
///           (1995); the difference is largest at 380 nm
double rayleigh_cross_section_m2(double refractivity, double king_factor,
                                 algebra::Wavelength wavelength);

/// King factor of air: the factor by which the anisotropy of its molecules increases scattering.
///
///     F = Σ C_i F_i / Σ C_i       N₂ 78.084 %: 1.034 + 3.17e-4/λ²        Ar 0.934 %: 1.00
///     O₂ 20.946 %: 1.096 + 1.385e-3/λ² + 1.448e-4/λ⁴        CO₂ 0.036 %: 1.15        λ in µm
///
/// Given     wavelength  380 to 780 nm
/// Returned  F           1.04882 at 550 nm
/// Throws    Error       when the wavelength is outside its range
/// Source    Bates (1984), Planet. Space Sci. 32, 785; weighted as in Bodhaine et al. (1999),
///           J. Atmos. Oceanic Technol. 16, 1854, Eq. 23
double king_factor_bates_1984(algebra::Wavelength wavelength);

}  // namespace coppermoon::atmosphere
