// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/quantity.h"

namespace coppermoon::atmosphere {

/// Number density of oxygen molecules at sea level, US 1976 [m⁻³].
inline constexpr double sea_level_oxygen_per_m3 = 0.209476 * 2.54693e25;

/// Absorption coefficient of oxygen pairs (O₂–O₂), divided by the square of oxygen's number density.
///
/// Given     wavelength  380 to 780 nm
/// Returned  [m⁵]        at most 1e-55, at 577 nm
/// Accuracy  6 %, because in cold air (253 K) the bands are narrower and higher, with the same integral
/// Omits     bands beyond 666 nm, which lie under oxygen's B band and reach a thirtieth of the largest value
/// Throws    Error       when the wavelength is outside its range
/// Source    Fally et al. (2000), J. Mol. Spectrosc. 204, 10
double oxygen_pair_cross_section_m5(algebra::Wavelength wavelength);

/// Absorption cross-section of a nitrogen dioxide molecule, averaged over 5 nm.
///
/// Given     wavelength  380 to 780 nm
/// Returned  [m²]        6.4e-23 at 400 nm
/// Throws    Error       when the wavelength is outside its range
/// Source    JPL Publication 06-2 (2006); Vandaele et al. (1998), JQSRT 59, 171
double nitrogen_dioxide_cross_section_m2(algebra::Wavelength wavelength);

/// Extinction at sea level by the bands of oxygen at 628, 688 and 762 nm, along rays that pass the limb:
///
///     −ln T = extinction ∫ ρ/ρ₀ ds        T: mean transmittance over 20 nm
///
/// A band's transmittance is exp(−(C W)^0.5641), with W = ∫ ρ p^0.9353 ds. So −ln T is about proportional to the square
/// root of W, and decreases with tangent height as the density does.
///
/// Given     wavelength  380 to 780 nm
/// Returned  [m⁻¹]       at most 2.4e-6, at 765 nm
/// Accuracy  of the loss of light: 15 % at 628 and 688 nm, 35 % at 762 nm (saturated), at tangent heights of 3 to 20 km
/// Omits     spectral detail narrower than 20 nm
/// Throws    Error       when the wavelength is outside its range
/// Source    band model of LOWTRAN 7: Kneizys et al. (1988), AFGL-TR-88-0177
double oxygen_bands_per_m(algebra::Wavelength wavelength);

/// Extinction at sea level by the bands of water vapour at 590, 650, 695 and 725 nm, along rays that pass the limb:
///
///     −ln T = extinction ∫ water_vapour_profile ds        T: mean transmittance over 20 nm
///
/// Extinction is taken to be proportional to water^0.62; the exponents in the band model are 0.61 to 0.66.
///
/// Given     water       relative to the US standard atmosphere (14 mm of precipitable water), 0 or more
///           wavelength  380 to 780 nm
/// Returned  [m⁻¹]       at most 6.8e-6, at 725 nm and water = 1
/// Accuracy  of the loss of light: 15 %, for tangent heights of 2 to 8 km
/// Omits     spectral detail narrower than 20 nm
/// Throws    Error       when the wavelength is outside its range
/// Source    as for oxygen_bands_per_m
double water_vapour_per_m(double water, algebra::Wavelength wavelength);

/// Ratio of extinction by water vapour at an altitude to that at sea level: (vapour density × pressure^0.66)^0.62.
///
/// Given     altitude_m  above sea level
/// Accuracy  0.03 in the ratio
/// Source    US standard atmosphere of Anderson et al. (1986), AFGL-TR-86-0110
double water_vapour_profile(double altitude_m);

/// Water vapour 5 km above sea level, by latitude and season, relative to the US standard atmosphere: 0.3 to 2.4.
///
/// Given   year   its fractional part gives the season
/// Throws  Error  when the latitude is outside ±90°
/// Omits   weather
/// Source  mixing ratios of Anderson et al. (1986), AFGL-TR-86-0110
double seasonal_water(algebra::Angle latitude, double year);

/// Number density of nitrogen dioxide [m⁻³]; the vertical column is 6.0e19 m⁻².
///
/// Given     altitude_m  0 to 86 km
/// Omits     changes with season and time of day; pollution in cities
/// Source    Anderson et al. (1986), AFGL-TR-86-0110
double nitrogen_dioxide_per_m3(double altitude_m);

}  // namespace coppermoon::atmosphere
