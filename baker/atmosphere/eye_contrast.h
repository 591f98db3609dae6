// SPDX-License-Identifier: MIT
#pragma once

namespace coppermoon::atmosphere {

/// Lowest contrast at which the eye sees a uniformly bright patch against the sky. The contrast is the luminance that
/// the patch adds to the sky, divided by the sky's luminance.
///
///     C = F ((R / A)^q + C∞^q)^(1/q)
///
///     √R = 6.505e-4 B^−¼ − 8.461e-4        C∞ = 7.633e-3 B^−¼ − 7.174e-3        for dark skies
///     √R = 1.772e-4 B^−¼ + 7.167e-5        C∞ = 2.720e-3                        for bright skies
///
/// R is the threshold for a point source [sr], C∞ that for a very large patch; q, 0.6 to 1.1, governs the transition.
///
/// Given     sky_cd_m2       B, above 0; values below 1e-5, where the sky looks black, count as 1e-5
///           solid_angle_sr  A, the solid angle of the patch; 6e-5 for the Moon
/// Returned  F times the contrast that is seen half of the time, with F = 2 for somebody outdoors who looks for the
///           patch. For the Moon: 0.6 % in a sky of 100 cd/m², 2.6 % at 0.1 cd/m², about 100 % on a moonless night
/// Accuracy  F is 1.4 to 2.4 for most observers
/// Source    Crumey (2014), MNRAS 442, 2600, eqs. 23 to 44, after Blackwell (1946) and Taylor (1960)
double contrast_threshold(double sky_cd_m2, double solid_angle_sr);

}  // namespace coppermoon::atmosphere
