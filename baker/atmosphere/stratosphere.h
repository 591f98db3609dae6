// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "algebra/interpolation.h"
#include "algebra/quantity.h"

namespace coppermoon::atmosphere {

/// Amount of sulphuric acid and ash in the stratosphere, from none through years without eruptions (background)
/// to a fresh eruption (extreme). Vertical optical depths at 550 nm, above 9 km, are 0, 0.008, 0.028, 0.086, 0.262.
enum class StratosphericAerosol { none, background, moderate, high, extreme };

/// Extinction by stratospheric aerosol at 550 nm [m⁻¹].
///
/// Given     altitude_m  from 11 down to 9 km, where tropospheric aerosol takes over, the extinction fades
///                       out; above 100 km the extinction is 0
/// Returned  [m⁻¹]       at 20 km, from background to extreme, 5.1e-7, 1.35e-6, 8.4e-6, 5.5e-5
/// Accuracy  matches the printed profiles at their altitudes. Optical depths above 11 km are 0.0072, 0.0269, 0.0844 and
///           0.260; those of the printed profiles are 0.0072, 0.0269, 0.0843 and 0.257
/// Omits     season; profiles are means of spring-summer and fall-winter
/// Source    LOWTRAN 7: Kneizys et al. (1988), AFGL-TR-88-0177
double stratospheric_extinction_per_m(StratosphericAerosol aerosol, double altitude_m);

/// Ratio of a stratospheric aerosol's extinction at a wavelength to its extinction at 550 nm. The aerosol is 75 %
/// sulphuric acid (background), aged volcanic (moderate, high) or fresh volcanic (extreme). Between the printed
/// wavelengths the logarithm is interpolated linearly.
///
/// Given     wavelength  380 to 780 nm
/// Returned  1 at 550 nm, and if there is no aerosol
/// Throws    Error       when the wavelength is outside its range
/// Source    LOWTRAN 7: Kneizys et al. (1988), AFGL-TR-88-0177
double stratospheric_spectrum(StratosphericAerosol aerosol, algebra::Wavelength wavelength);

/// Vertical optical depth of the stratosphere's aerosol at 550 nm over a latitude, by month.
///
/// Given     year      with a fractional part; constant before 500 BC, the mean of 2014 to 2018 from 2027 on
///           latitude  interpolated linearly: from 1979 on between the middles of six bands, from 1850 on between the
///                     hemispheres' means at 20° south and 20° north; before 1850, all latitudes have the global mean
/// Returned  0.003 to 0.012 in quiet years, 0.1 after great eruptions, 0.5 in 1258
/// Accuracy  10 % from 1979 to 2016, when bands were measured. Until 2024, 5 % for the global mean, 20 % for a band, a
///           third for the aerosol of Hunga (from January 2022); 30 % in 2025; 20 to 50 % before 1979. For eruptions
///           before 1850 only the year is known, not the hemisphere
/// Source    from 1979 on, GloSSAC (Thomason et al. 2018, Earth Syst. Sci. Data 10, 469, and version 2.23), with the
///           eruptions of MSVOLSO2L4 (Carn) in the boxes of EVA_H (Aubry et al. 2020), and OMPS-LP in 2025; from 1850
///           on, Sato et al. (1993); before, Toohey & Sigl (2017), as in IPCC AR6 WG1 ch. 7
double stratospheric_optical_depth(double year, algebra::Angle latitude);

/// Standard error of the global mean of stratospheric_optical_depth.
///
/// Returned  40 % of the mean until 1849, 30 % until 1978, 10 % until 2016, 15 % until 2021, 25 % until 2024, 30 % in
///           2025; from 2026 on 0.003, half the width of the range that holds 68 % of the months from 1997 to 2025, so
///           great eruptions lie outside
double stratospheric_depth_error(double year);

/// Ångström's exponent of the stratosphere's aerosol between 550 and 1020 nm over a latitude.
///
/// Given     year  1979 or later, with a fractional part
/// Returned  1.4 to 2.2 in quiet years, 0.3 to 1 after great eruptions, whose particles are large
/// Accuracy  0.3 until 2016, from two versions of GloSSAC; 0.5 from 2017 on, when only Hunga's differs from 1.65
/// Throws    Error  when the year is before 1979
double stratospheric_exponent(double year, algebra::Angle latitude);

/// Profile and colour of stratospheric aerosol with any optical depth.
class StratosphericLayer {
 public:
  /// Layer with a given optical depth. Profile and spectrum are LOWTRAN 7's, interpolated (in the logarithm) between
  /// the two named aerosols of neighbouring optical depth, and constant beyond the first and the last. The profile
  /// begins at the tropopause, not at 11 km, so altitudes from the tropopause to 35 km are stretched.
  ///
  /// Given   optical_depth  vertical, at 550 nm, 0 to 2
  ///         tropopause_m   5 to 20 km
  /// Throws  Error          when an argument is outside its range
  StratosphericLayer(double optical_depth, double tropopause_m);

  /// Layer for a month over a latitude. From 1979 on it has separate optical depths below 16 km, from 16 to 20 km and
  /// above, each with the profile of aerosol from eruptions (EVA_H), and fades out within 2 km under the tropopause.
  /// Its spectrum is interpolated between those of LOWTRAN 7 by the Ångström exponent. Before 1979 the layer is
  /// LOWTRAN's for the month's optical depth.
  static StratosphericLayer of_month(double year, algebra::Angle latitude, double tropopause_m);

  /// Layer with the same profile and another optical depth, 0 to 2. Its spectrum changes as that of LOWTRAN's
  /// aerosol does between the two optical depths.
  StratosphericLayer with_optical_depth(double optical_depth) const;

  double optical_depth() const { return optical_depth_; }
  /// Whether the profile comes from the record for a month. If so, another optical depth only scales the profile.
  bool recorded() const { return recorded_ != nullptr; }
  /// Extinction at 550 nm [m⁻¹].
  double extinction_per_m(double altitude_m) const;
  /// Ratio of extinction at a wavelength to extinction at 550 nm.
  ///
  /// Given  factor  by which the optical depth is multiplied, which changes the spectrum as in with_optical_depth
  double spectrum(algebra::Wavelength wavelength, double factor = 1) const;
  /// Named aerosol with the most similar spectrum.
  StratosphericAerosol nearest() const;

 private:
  double optical_depth_, tropopause_m_;
  double
      grade_;  ///< place among LOWTRAN's spectra and profiles, from 1 (background) to 4 (extreme)
  double scale_ = 1;
  std::shared_ptr<const algebra::MonotoneCubic>
      recorded_{};  ///< extinction [1/m]; if null, LOWTRAN's

  double unscaled(double altitude_m) const;
  void normalise();  ///< sets scale_ to match the optical depth
  double grade_at(double optical_depth) const;
};

}  // namespace coppermoon::atmosphere
