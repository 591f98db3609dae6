// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/interpolation.h"
#include "algebra/quantity.h"

namespace coppermoon::atmosphere {

/// How much sulphuric acid and ash hang in the stratosphere: clear since years, or after a volcano
/// has erupted. Vertical optical depths at 550 nm, above 9 km: 0, 0.008, 0.028, 0.086, 0.262.
enum class StratosphericAerosol { none, background, moderate, high, extreme };

/// Extinction by that aerosol at 550 nm [m⁻¹].
///
/// Given     altitude_m  fades out from 11 down to 9 km, where the tropospheric aerosol is; 0 above
///                       100 km
/// Returned  [m⁻¹]       5.1e-7, 1.35e-6, 8.4e-6, 5.5e-5 at 20 km
/// Accuracy  the printed profiles at their altitudes; above 11 km optical depths 0.0072, 0.0269,
///           0.0844 and 0.260 where theirs are 0.0072, 0.0269, 0.0843 and 0.257
/// Omits     season: the mean of spring-summer and fall-winter
/// Source    LOWTRAN 7: Kneizys et al. (1988), AFGL-TR-88-0177
double stratospheric_extinction_per_m(StratosphericAerosol aerosol, double altitude_m);

/// Extinction at a wavelength over that at 550 nm: of 75 % sulphuric acid (background), aged
/// (moderate, high) or fresh (extreme) volcanic aerosol, straight lines between logarithms.
///
/// Given     wavelength  380 to 780 nm
/// Returned  1 at 550 nm; 1 where there is no aerosol
/// Throws    Error       when the wavelength is outside its range
/// Source    LOWTRAN 7: Kneizys et al. (1988), AFGL-TR-88-0177
double stratospheric_spectrum(StratosphericAerosol aerosol, algebra::Wavelength wavelength);

/// Vertical optical depth of the stratosphere's aerosol at 550 nm, by month.
///
/// Given     year      with its fraction; held before 500 BC; the mean of quiet years from 2027 on
///           latitude  straight between the hemispheres' means at 20° south and 20° north
/// Returned  0.003 to 0.008 in quiet years, 0.1 after great eruptions, 0.5 in 1258
/// Accuracy  10 % in the satellites' years, from 1979; 20 to 50 % before; of eruptions before 1850 the
///           year, and no hemisphere; none either from 2013 on, when all stands for both
/// Source    IPCC AR6 WG1 ch. 7 (Toohey & Sigl 2017 to 1850); Sato et al. (1993) for the hemispheres, 1850
///           to 2012; Indicators of Global Climate Change, 2019 to 2025
double stratospheric_optical_depth(double year, algebra::Angle latitude);

/// Stratospheric aerosol of any optical depth: its profile lies between those of LOWTRAN 7 that are
/// next to it (in the logarithm; beyond the first and the last it is theirs), and so does its spectrum.
/// The profile begins at the tropopause, not at 11 km: altitudes from there to 35 km are stretched.
class StratosphericLayer {
 public:
  /// Given   optical_depth  vertical, at 550 nm, 0 to 2
  ///         tropopause_m   5 to 20 km
  /// Throws  Error          when an argument is outside its range
  StratosphericLayer(double optical_depth, double tropopause_m);

  double optical_depth() const { return optical_depth_; }
  /// Extinction at 550 nm [m⁻¹].
  double extinction_per_m(double altitude_m) const;
  /// Extinction at a wavelength over that at 550 nm.
  double spectrum(algebra::Wavelength wavelength) const;
  /// Named aerosol of the nearest optical depth.
  StratosphericAerosol nearest() const;

 private:
  double optical_depth_, tropopause_m_, grade_, scale_ = 1;

  double unscaled(double altitude_m) const;
};

/// Extinction at 550 nm and 7 km by the aerosol of the free troposphere, in years without eruptions: of
/// 1.02 µm it runs straight from 1e-4 km⁻¹ at 70° south to 7e-4 km⁻¹ at 70° north, and is 2.2 times as
/// much at 550 nm (Ångström's exponent 1.3).
///
/// Returned  [m⁻¹]  2.2e-7 to 1.5e-6
/// Accuracy  a factor of two
/// Source    Kent et al. (1998), J. Geophys. Res. 103, 28863: SAGE I and II, 6 km to the tropopause
double free_troposphere_per_m(algebra::Angle latitude);

/// Extinction by the aerosol of the free troposphere at an altitude, over that at 7 km.
///
///     exp(−(h − 7 km) / 3 km)
///
/// Returned  0 from 2 km above the tropopause on
/// Accuracy  LOWTRAN 7 has 2.6 km as scale height between 3 and 10 km
double free_troposphere_profile(double tropopause_m, double altitude_m);

/// Share of the vertical optical depth of the tropospheric aerosol in a metre of altitude [m⁻¹].
///
///     exp(−h/H) / H
///
/// Given     scale_m  H: 1.2 km of the layer that the ground stirs, above which that of the free
///                    troposphere follows; 2 km of all, alone
/// Accuracy  of 2 km: between 3 and 10 km it falls by 33, the profiles of LOWTRAN 7 for 23 km of
///           visibility by 30 (spring-summer) and 35 (fall-winter)
/// Source    Elterman (1968), AFCRL-68-0153, for 1.2 km; LOWTRAN 7: Kneizys et al. (1988),
///           AFGL-TR-88-0177
double tropospheric_profile_per_m(double scale_m, double altitude_m);

/// Extinction by the tropospheric aerosol at a wavelength over that at 550 nm.
///
///     (λ / 550 nm)^−1.3
///
/// Given     wavelength  380 to 780 nm
/// Throws    Error       when the wavelength is outside its range
/// Source    Ångström (1964), Tellus 16, 64: the mean exponent
double tropospheric_spectrum(algebra::Wavelength wavelength);

}  // namespace coppermoon::atmosphere
