// SPDX-License-Identifier: MIT
#pragma once

namespace coppermoon::atmosphere {

/// Least contrast at which the eye sees a uniform light against the sky: the luminance that the light adds, relative
/// to the sky's.
///
///     C = F ((R / A)^q + C∞^q)^(1/q)
///
///     √R = 6.505e-4 B^−¼ − 8.461e-4        C∞ = 7.633e-3 B^−¼ − 7.174e-3        of dark skies
///     √R = 1.772e-4 B^−¼ + 7.167e-5        C∞ = 2.720e-3                        of bright ones
///
/// R is the threshold for a point [sr], C∞ that for a wide field, and q, 0.6 to 1.1, governs the transition.
///
/// Given     sky_cd_m2       B, above 0; held at 1e-5, below which the eye sees no sky
///           solid_angle_sr  A, of the light; 6e-5 for the Moon
/// Returned  F times the contrast that is seen half of the time; F is 2, for somebody who looks for the light outdoors.
///           For the Moon, 0.6 % in a sky of 100 cd/m², 2.6 % at 0.1 cd/m², as much as the sky of a moonless night
/// Accuracy  F is 1.4 to 2.4 for most observers
/// Source    Crumey (2014), MNRAS 442, 2600, eqs. 23 to 44, after Blackwell (1946) and Taylor (1960)
double contrast_threshold(double sky_cd_m2, double solid_angle_sr);

}  // namespace coppermoon::atmosphere
