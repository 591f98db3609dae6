// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/quantity.h"

namespace coppermoon::surface {

/// Photometric functions. Each is the ratio f of radiance factor (I/F) to normal albedo. mu0 and mu are the cosines of
/// the angles from the surface normal to the Sun and to the viewer; g is the phase angle.
enum class Photometry {
  /// Yapo & Cutler's function. With it the full Moon does not darken until close to the limb.
  ///
  ///     f(mu0) = mu0 / (0.1 + 0.9 mu0)
  ///
  /// The numerator is Lambert's cosine, the denominator the paper's correction. The mean over the disc of the full
  /// Moon, 2 times the integral of mu f(mu) over 0 < mu < 1, is 0.92737.
  ///
  /// Omits     dependence on phase angle (no opposition surge) and on emission angle (equal radiance in all directions)
  /// Source    Yapo & Cutler (2009), Rendering Lunar Eclipses, Eq. 13
  yapo_cutler,
  /// Lommel-Seeliger law, with the phase curve that reproduces ROLO's measurements of the whole disc:
  ///
  ///     f(mu0, mu, g) = 2 mu0 / (mu0 + mu) F(g) / F(1.5 deg)        F(g) = A(g) / Phi(g)
  ///     ln A = sum_i a_i g^i + d1 exp(-g/4.06054) + d2 exp(-g/12.8802)
  ///            + d3 cos((g + 30.5858)/16.7498)                      g [deg], but [rad] in the sum
  ///     Phi = 1 - sin(g/2) tan(g/2) ln cot(g/4)
  ///
  /// A is the disc reflectance. Its coefficients are the means of those for the bands at 544.0, 549.1 and 553.8 nm, so
  /// A is the geometric mean of these bands. Phi is the phase curve of a uniform Lommel-Seeliger sphere. f is 0 to
  /// 2.32; it is largest, 2 F/F(1.5 deg), at grazing emission. ROLO observed phases from 1.55 to 97 degrees. Below 1.55
  /// degrees the expression is extrapolated, to F(0)/F(1.5 deg) = 1.157; beyond 97 degrees F is constant.
  ///
  /// Accuracy  for the whole disc, 1 % compared with ROLO's three bands from 1.55 to 10 degrees, and 0.06 magnitudes
  ///           compared with Allen's phase law from 10 to 90 degrees. Highlands and maria have the same phase curve
  ///           (surge_slope gives their deviations)
  /// Omits     local variation of the surge's width; the surge's colour (a few percent); roughness, which matters far
  ///           from full Moon; the difference of a few percent between the waxing and the waning Moon
  /// Source    Kieffer & Stone (2005), The spectral irradiance of the Moon, AJ 129, 2887, Table 4;
  ///           Phi: Hapke (2012), Theory of Reflectance and Emittance Spectroscopy
  lommel_seeliger_rolo,
};

/// Phase angle at which both photometric functions are 1 at normal incidence, and for which the full Moon's geometric
/// albedo is given. It is about the smallest phase angle outside an eclipse.
inline constexpr algebra::Angle full_moon_phase = algebra::degrees(1.5);

/// Ratio of radiance factor to normal albedo, according to one of the photometric functions.
///
/// Given     cos_incidence  mu0, cosine of the angle between the surface normal and the Sun
///           cos_emission   mu, cosine of the angle between the normal and the viewer; negative values count as 0
///           phase          g, angle between the directions to the Sun and to the viewer
/// Returned  0 if mu0 <= 0
double radiance_factor(Photometry photometry, double cos_incidence, double cos_emission,
                       algebra::Angle phase);

/// Coefficients for a photometric function's dependence on the cosines, for fast evaluation at many places:
///
///     f(mu0, mu, g) = scale mu0 / (incidence mu0 + emission max(mu, 0) + constant) P(g)
///
/// where P is the phase factor. The denominator is positive whenever mu0 is positive.
struct CosineLaw {
  double scale, incidence, emission, constant;
};
CosineLaw cosine_law(Photometry photometry);

/// Phase factor P of a photometric function, 1 at full Moon.
double phase_factor(Photometry photometry, algebra::Angle phase);

/// Ratio of radiance factor to normal albedo on the full Moon's disc, at a phase angle of 1.5 degrees but with Sun and
/// viewer in the same direction (mu0 = mu). With lommel_seeliger_rolo the ratio is 1 up to the limb.
double radiance_factor_at_full_moon(Photometry photometry, double cos_incidence);

}  // namespace coppermoon::surface
