// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/interpolation.h"
#include "algebra/quantity.h"
#include "atmosphere/seasonal_air.h"

namespace coppermoon::atmosphere {

/// Absorption cross-section of an ozone molecule, Chappuis band, averaged over 5 nm.
///
/// Given     wavelength  380 to 780 nm
/// Returned  [m²]        5.1e-25 near 602 nm
/// Throws    Error       when the wavelength is outside its range
/// Source    Serdyuchenko, Gorshelev et al. (2014), Atmos. Meas. Tech. 7, 625; 233 K
double ozone_cross_section_m2(algebra::Wavelength wavelength);

/// Share of the vertical ozone column per metre of altitude [m⁻¹]. The integral of the share from 0 to 86 km is 1; the
/// share times the column [m⁻²] is the number density.
///
/// Given     altitude_m  below 2 km, the value at 2 km is returned; above 86 km, 0
/// Returned  [m⁻¹]       at most 5.2e-5, at 22 km
/// Accuracy  matches the printed profile, which has values every 2 km from 2 to 74 km; in between, the logarithm
///           follows a smooth curve. The column of the printed profile is 347 DU, although its text says 345
/// Omits     season, latitude and weather; in reality the peak is at 26 km in the tropics, and at 18 km at the poles
/// Source    U.S. Standard Atmosphere 1976, mid-latitude ozone (Krueger & Minzner 1976)
double ozone_profile_per_m(double altitude_m);

/// Climatological ozone over a latitude in a month: vertical column and profile.
///
/// Source  McPeters, Labow & Logan (2007), J. Geophys. Res. 112, D05308
class OzoneClimate {
 public:
  /// Given     latitude  −90° to 90°; interpolated linearly between belts of 10°
  ///           year      its fractional part gives the season; interpolated linearly between months
  ///           air       air over the same latitude, needed to convert the climatology's pressures to altitudes
  /// Accuracy  the column is exactly the climatology's; the profile reproduces its layers of 2 km, with a smooth curve
  ///           of the logarithm between the layers' middles
  /// Omits     weather and differences between years, ±10 % of the column; the ozone holes of individual years
  OzoneClimate(algebra::Angle latitude, double year, const SeasonalAir& air);

  /// Vertical column of ozone [DU]: 250 in the tropics, 150 to 440 elsewhere.
  double column_du() const { return column_du_; }

  /// Share of the vertical ozone column per metre of altitude [m⁻¹], from 0 to 86 km.
  double profile_per_m(double altitude_m) const;

 private:
  double column_du_;
  algebra::MonotoneCubic log_share_per_m_;
};

/// One Dobson unit as a number of molecules above a square metre [m⁻²].
inline constexpr double dobson_unit_per_m2 = 2.6867e20;

/// Air mass of ozone on a ray that grazes the Earth: 2 / √(1 − (R/(R+22 km))²) with R = 6378 km, for a thin layer at an
/// altitude of 22 km, where the density of ozone is largest.
inline constexpr double grazing_ozone_air_mass = 24.1;

/// Transmittance of ozone as one filter for all light that passed the limb.
///
///     exp(−24.1 σ(λ) N_O3)
///
/// Given     dobson_units  vertical column, 0 to 1000 DU; the mean is about 300, US 1976 has 345
/// Omits     differences between low rays, which cross more ozone, and high ones; the layer's thickness
/// Throws    Error         when an argument is outside its range
/// Source    Yapo & Cutler (2009) §3.5 use one filter for the total mass of ozone, but do not print its values; the air
///           mass is the project's own
double ozone_filter_yapo_cutler(algebra::Wavelength wavelength, double dobson_units);

}  // namespace coppermoon::atmosphere
