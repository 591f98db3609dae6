// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/quantity.h"

namespace coppermoon::surface {

/// Laws of how bright a place looks: radiance factor (I/F) over normal albedo.
enum class Photometry {
  yapo_cutler,           ///< radiance_factor_yapo_cutler: the same at every phase
  lommel_seeliger_rolo,  ///< radiance_factor_lommel_seeliger_rolo: with the opposition surge
};

/// The phase at which both functions are 1 where light falls straight down, and at which "the full
/// Moon" has its geometric albedo: about the smallest that is seen outside an eclipse.
inline constexpr algebra::Angle full_moon_phase = algebra::degrees(1.5);

/// How bright a place looks by either function.
///
/// Given     cos_incidence  mu0, of the angle between the surface normal and the Sun
///           cos_emission   mu, of the angle between the surface normal and the viewer; below 0
///                          counts as 0
///           phase          g, between the directions to the Sun and to the viewer
/// Returned  0 where mu0 <= 0
double radiance_factor(Photometry photometry, double cos_incidence, double cos_emission,
                       algebra::Angle phase);

/// How either function depends on the cosines, for many places at once:
///
///     f(mu0, mu, g) = scale mu0 / (incidence mu0 + emission max(mu, 0) + constant) P(g)
///
/// with P the phase factor. The denominator is above 0 where mu0 is.
struct CosineLaw {
  double scale, incidence, emission, constant;
};
CosineLaw cosine_law(Photometry photometry);

/// How either function depends on the phase alone: 1 at full Moon.
double phase_factor(Photometry photometry, algebra::Angle phase);

/// Radiance factor on the full Moon's disc, where Sun and viewer stand together: mu0 = mu, phase 1.5
/// degrees. With lommel_seeliger_rolo it is 1 up to the limb.
double radiance_factor_at_full_moon(Photometry photometry, double cos_incidence);

/// A flat full Moon: no darkening until close to the limb.
///
///     f(mu0) = mu0 / (0.1 + 0.9 mu0)
///
/// The numerator is the cosine with which light spreads over slanting ground, the denominator is
/// the paper's correction of it.
///
/// Returned  0 where mu0 <= 0; the mean over the disc of the full Moon, 2 times the integral of
///           mu f(mu) over 0 < mu < 1, is 0.92737
/// Omits     phase: no opposition surge, the same from wherever it is seen
/// Source    Yapo & Cutler (2009), Rendering Lunar Eclipses, Eq. 13
double radiance_factor_yapo_cutler(double cos_incidence);

/// The Lommel-Seeliger law, with the phase curve that makes the whole disc as bright as the ROLO
/// telescopes measured it:
///
///     f(mu0, mu, g) = 2 mu0 / (mu0 + mu) F(g) / F(1.5 deg)        F(g) = A(g) / Phi(g)
///     ln A = sum_i a_i g^i + d1 exp(-g/4.06054) + d2 exp(-g/12.8802)
///            + d3 cos((g + 30.5858)/16.7498)                      g [deg], but [rad] in the sum
///     Phi = 1 - sin(g/2) tan(g/2) ln cot(g/4)
///
/// A is the disc reflectance, its coefficients the mean of the bands at 544.0, 549.1 and 553.8 nm
/// (so A is their geometric mean); Phi is the phase curve of a uniform Lommel-Seeliger sphere.
///
/// Given     phase     g; ROLO observed 1.55 to 97 degrees. Below, the same expression goes on, to
///                     F(0)/F(1.5 deg) = 1.157; beyond 97 degrees F is held
/// Returned  0 to 2.32: twice F/F(1.5 deg) where light is aslant but the viewer's line grazes
/// Accuracy  the disc: 1 % of ROLO's three bands from 1.55 to 10 degrees, 0.06 magnitudes of
///           Allen's phase law from 10 to 90. Places: highlands and maria are given one phase curve
///           (surge_slope says how each departs from it)
/// Omits     a width of the surge by place, its colour (some percent), roughness, which
///           matters far from full Moon, and that the waxing Moon is brighter than the waning one
///           by some percent
/// Source    Kieffer & Stone (2005), The spectral irradiance of the Moon, AJ 129, 2887, Table 4;
///           Phi: Hapke (2012), Theory of Reflectance and Emittance Spectroscopy
double radiance_factor_lommel_seeliger_rolo(double cos_incidence, double cos_emission,
                                            algebra::Angle phase);

}  // namespace coppermoon::surface
