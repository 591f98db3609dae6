// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/quantity.h"

namespace coppermoon::atmosphere {

/// Absorption cross-section of an ozone molecule, Chappuis band, means over 5 nm.
///
/// Given     wavelength  380 to 780 nm
/// Returned  [m²]        5.1e-25 near 602 nm
/// Throws    Error       when the wavelength is outside its range
/// Source    Serdyuchenko, Gorshelev et al. (2014), Atmos. Meas. Tech. 7, 625; 233 K
double ozone_cross_section_m2(algebra::Wavelength wavelength);

/// One Dobson unit: molecules over a square metre [m⁻²].
inline constexpr double dobson_unit_per_m2 = 2.6867e20;

/// How many times the vertical column a ray that grazes the Earth crosses of a thin layer at 22 km,
/// the altitude where ozone peaks: 2 / √(1 − (R/(R+22 km))²), R = 6378 km.
inline constexpr double grazing_ozone_air_mass = 24.1;

/// Transmittance of the whole ozone for light that passed the limb: one spectral filter.
///
///     exp(−24.1 σ(λ) N_O3)
///
/// Given     dobson_units  vertical column, 0 to 1000 DU; the mean is about 300, US 1976 has 345
/// Omits     that low rays cross more of it than high ones; the exact air mass of the layer
/// Throws    Error         when an argument is outside its range
/// Source    Yapo & Cutler (2009) §3.5 use one filter for the total mass of ozone, not printed;
///           the grazing air mass is ours
double ozone_filter_yapo_cutler(algebra::Wavelength wavelength, double dobson_units);

}  // namespace coppermoon::atmosphere
