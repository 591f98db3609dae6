// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "algebra/interpolation.h"
#include "algebra/quantity.h"

namespace coppermoon::atmosphere {

/// Amount of sulphuric acid and ash in the stratosphere: `background` is that of years without eruptions, and `extreme`
/// that after a fresh eruption. Vertical optical depths above 9 km at 550 nm are 0, 0.008, 0.028, 0.086 and 0.262.
enum class StratosphericAerosol { none, background, moderate, high, extreme };

/// Extinction by stratospheric aerosol at 550 nm [m⁻¹].
///
/// Given     altitude_m  from 11 down to 9 km the extinction fades to 0, because tropospheric aerosol takes over; above
///                       100 km it is 0
/// Returned  [m⁻¹]       at 20 km, from background to extreme: 5.1e-7, 1.35e-6, 8.4e-6 and 5.5e-5
/// Accuracy  matches the printed profiles at their altitudes. Optical depths above 11 km are 0.0072, 0.0269, 0.0844 and
///           0.260; those of the printed profiles are 0.0072, 0.0269, 0.0843 and 0.257
/// Omits     season, because the profiles are means of spring-summer and fall-winter
/// Source    LOWTRAN 7: Kneizys et al. (1988), AFGL-TR-88-0177
double stratospheric_extinction_per_m(StratosphericAerosol aerosol, double altitude_m);

/// Ratio of a stratospheric aerosol's extinction at a wavelength to its extinction at 550 nm. The aerosol is 75 %
/// sulphuric acid (background), aged volcanic (moderate, high) or fresh volcanic (extreme). Between the printed
/// wavelengths, the ratio's logarithm is interpolated linearly.
///
/// Given     wavelength  380 to 780 nm
/// Returned  1 at 550 nm, and at any wavelength if there is no aerosol
/// Throws    Error       when the wavelength is outside its range
/// Source    LOWTRAN 7: Kneizys et al. (1988), AFGL-TR-88-0177
double stratospheric_spectrum(StratosphericAerosol aerosol, algebra::Wavelength wavelength);

/// Vertical optical depth of the stratosphere's aerosol at 550 nm, over a latitude in a month.
///
/// Given     year      with a fractional part; before 500 BC values are constant, from 2027 on the mean of 2014 to 2018
///           latitude  interpolated linearly: from 1979 on between the middles of six bands, from 1850 on between the
///                     hemispheres' means at 20° south and 20° north; before 1850, all latitudes have the global mean
/// Returned  0.003 to 0.012 in quiet years, 0.1 after great eruptions, 0.5 in 1258
/// Accuracy  10 % from 1979 to 2016, when bands were measured; until 2024, 5 % for the global mean, 20 % for a band,
///           and a third for the aerosol of Hunga (from January 2022); 30 % in 2025; 20 to 50 % before 1979. For
///           eruptions before 1850, only the year is known, not the hemisphere
/// Source    from 1979 on, GloSSAC (Thomason et al. 2018, Earth Syst. Sci. Data 10, 469, and version 2.23), with the
///           eruptions of MSVOLSO2L4 (Carn) in the model EVA_H (Aubry et al. 2020), and OMPS-LP in 2025; from 1850
///           on, Sato et al. (1993); before, Toohey & Sigl (2017), as in IPCC AR6 WG1 ch. 7
double stratospheric_optical_depth(double year, algebra::Angle latitude);

/// Standard error of the global mean of stratospheric_optical_depth.
///
/// Returned  40 % of the mean until 1849, 30 % until 1978, 10 % until 2016, 15 % until 2021, 25 % until 2024, 30 % in
///           2025. From 2026 on, an optical depth of 0.003: half the width of the range that contains 68 % of the
///           months from 1997 to 2025. A great eruption would lie outside this range
double stratospheric_depth_error(double year);

/// Ångström exponent of the stratosphere's aerosol between 550 and 1020 nm, over a latitude in a month.
///
/// Given     year  1979 or later, with a fractional part
/// Returned  1.4 to 2.2 in quiet years, 0.3 to 1 after great eruptions, whose particles are large
/// Accuracy  0.3 until 2016, judging by two versions of GloSSAC; 0.5 from 2017 on, when 1.65 is assumed for all aerosol
///           except that of Hunga
/// Throws    Error  when the year is before 1979
double stratospheric_exponent(double year, algebra::Angle latitude);

/// Profile and spectrum of stratospheric aerosol with a given optical depth.
class StratosphericLayer {
 public:
  /// Layer with a given optical depth. Profile and spectrum are interpolated logarithmically between the two of LOWTRAN
  /// 7's aerosols with the nearest optical depths, and constant beyond the smallest and the largest. The profile begins
  /// at the tropopause instead of 11 km, and is stretched between the tropopause and 35 km.
  ///
  /// Given   optical_depth  vertical, at 550 nm, 0 to 2
  ///         tropopause_m   5 to 20 km
  /// Throws  Error          when an argument is outside its range
  StratosphericLayer(double optical_depth, double tropopause_m);

  /// Layer over a latitude in a month. From 1979 on it has separate optical depths below 16 km, from 16 to 20 km and
  /// above 20 km, each with the profile of volcanic aerosol (EVA_H), and fades out in the 2 km below the tropopause.
  /// Its spectrum is interpolated between LOWTRAN 7's spectra to match the Ångström exponent. Before 1979, profile and
  /// spectrum are LOWTRAN's for the month's optical depth.
  static StratosphericLayer of_month(double year, algebra::Angle latitude, double tropopause_m);

  /// Layer with the same profile and a different optical depth, 0 to 2. The spectrum changes as much as that of
  /// LOWTRAN's aerosol does between the old and the new optical depth.
  StratosphericLayer with_optical_depth(double optical_depth) const;

  double optical_depth() const { return optical_depth_; }
  /// Whether the profile comes from the record of monthly aerosol. Such a profile is only scaled by with_optical_depth.
  bool recorded() const { return recorded_ != nullptr; }
  /// Extinction at 550 nm [m⁻¹].
  double extinction_per_m(double altitude_m) const;
  /// Ratio of extinction at a wavelength to extinction at 550 nm.
  ///
  /// Given  factor  multiplies the optical depth, so that the spectrum changes as in with_optical_depth
  double spectrum(algebra::Wavelength wavelength, double factor = 1) const;
  /// The StratosphericAerosol with the most similar spectrum.
  StratosphericAerosol nearest() const;

 private:
  double optical_depth_, tropopause_m_;
  double
      grade_;  ///< position on the scale of LOWTRAN's aerosols, from 1 (background) to 4 (extreme)
  double scale_ = 1;
  std::shared_ptr<const algebra::MonotoneCubic>
      recorded_{};  ///< recorded extinction [1/m]; if nullptr, LOWTRAN's is used

  double unscaled(double altitude_m) const;
  void normalise();  ///< sets scale_ to match the optical depth
  double grade_at(double optical_depth) const;
};

}  // namespace coppermoon::atmosphere
