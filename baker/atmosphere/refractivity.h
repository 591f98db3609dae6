// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/quantity.h"

namespace coppermoon::atmosphere {

/// Shortest and longest wavelength of the model [nm].
inline constexpr double shortest_nm = 380, longest_nm = 780;

/// Converts a wavelength to nanometres.
///
/// Throws  Error  when the wavelength is outside 380 to 780 nm
double checked_nm(algebra::Wavelength wavelength);

/// Refractivity n₀ − 1 of air at sea level, 15 °C.
///
///     n₀ − 1 = 2.72643e-4 + 1.2288/λ² + 3.555e4/λ⁴        λ in nm
///
/// Given     wavelength  380 to 780 nm
/// Returned  n₀ − 1      2.770936e-4 at 550 nm
/// Accuracy  lower than Ciddor (1996) by 0.15 % (at 780 nm) to 0.38 % (at 380 nm)
/// Throws    Error       when the wavelength is outside its range
/// Source    CRC Handbook of Chemistry and Physics (1984), E-231. Eq. 4 of Yapo & Cutler
///           (2009) misprints the first two coefficients; the handbook's are used here
double sea_level_refractivity_crc(algebra::Wavelength wavelength);

/// Refractivity n₀ − 1 of dry air at sea level, 15 °C, 101 325 Pa, 450 ppm CO₂.
///
///     n₀ − 1 = 0.05792105/(238.0185 − s²) + 0.00167917/(57.362 − s²)        s = 1/λ in µm⁻¹
///
/// Given     wavelength  in vacuum, 380 to 780 nm
/// Returned  n₀ − 1      2.778376e-4 at 550 nm
/// Accuracy  exceeds the four-term formula of Peck & Reeder (1972) by a relative 6e-5
/// Omits     water vapour, which lowers refractivity by 3.6e-10 per pascal, or by 0.2 % when saturated
/// Throws    Error       when the wavelength is outside its range
/// Source    Ciddor (1996), Appl. Opt. 35, 1566, Eq. 1
double sea_level_refractivity_ciddor_1996(algebra::Wavelength wavelength);

}  // namespace coppermoon::atmosphere
