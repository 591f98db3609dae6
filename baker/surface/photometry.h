// SPDX-License-Identifier: MIT
#pragma once

namespace coppermoon::surface {

/// How bright a place looks when light comes in at an angle, seen from where the light comes from;
/// 1 where the light falls straight down. It makes the full Moon look flat: no darkening until
/// close to the limb.
///
///     f(mu) = mu / (0.1 + 0.9 mu)
///
/// The numerator is the cosine with which light spreads over slanting ground, the denominator is
/// the paper's correction of it.
///
/// Given     cos_incidence  mu, of the angle between the surface normal and the direction of the
/// Sun Returned  radiance factor (I/F) over normal albedo; 0 where mu <= 0. The mean over the disc
/// of the
///           full Moon is radiance_factor_yapo_cutler_disc_mean
/// Omits     phase: no opposition surge, the same from wherever it is seen. Between phases of 1.5
/// and
///           5 degrees the real Moon's radiance falls by a fifth
/// Source    Yapo & Cutler (2009), Rendering Lunar Eclipses, Eq. 13
double radiance_factor_yapo_cutler(double cos_incidence);

/// The mean of the above over the disc of the full Moon, 2 times the integral of mu f(mu) over
/// 0 < mu < 1:
///
///     2 (1/(2b) - a/b^2 + a^2/b^3 ln((a + b)/a)) = 0.92737        a = 0.1, b = 0.9
double radiance_factor_yapo_cutler_disc_mean();

}  // namespace coppermoon::surface
