// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/quantity.h"

namespace coppermoon::atmosphere {

/// Number density of oxygen molecules at sea level, US 1976 [m⁻³].
inline constexpr double sea_level_oxygen_per_m3 = 0.209476 * 2.54693e25;

/// Absorption coefficient of oxygen pairs (O₂–O₂), over the square of oxygen's number density.
///
/// Given     wavelength  380 to 780 nm
/// Returned  [m⁵]        at most 1e-55, at 577 nm
/// Accuracy  6 %: at 253 K the bands are narrower, with the same integral
/// Omits     bands beyond 666 nm: under the B band, a thirtieth of the largest value
/// Throws    Error       when the wavelength is outside its range
/// Source    Fally et al. (2000), J. Mol. Spectrosc. 204, 10
double oxygen_pair_cross_section_m5(algebra::Wavelength wavelength);

/// Absorption cross-section of a nitrogen dioxide molecule, means over 5 nm.
///
/// Given     wavelength  380 to 780 nm
/// Returned  [m²]        6.4e-23 at 400 nm
/// Throws    Error       when the wavelength is outside its range
/// Source    JPL Publication 06-2 (2006); Vandaele et al. (1998), JQSRT 59, 171
double nitrogen_dioxide_cross_section_m2(algebra::Wavelength wavelength);

/// Number density of nitrogen dioxide [m⁻³]; the vertical column is 6.0e19 m⁻².
///
/// Given     altitude_m  0 to 86 km
/// Omits     season, hour and cities
/// Source    Anderson et al. (1986), AFGL-TR-86-0110
double nitrogen_dioxide_per_m3(double altitude_m);

}  // namespace coppermoon::atmosphere
