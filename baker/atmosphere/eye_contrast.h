// SPDX-License-Identifier: MIT
#pragma once

namespace coppermoon::atmosphere {

/// Least contrast at which the eye sees a uniform light before a sky: luminance added by the light over the sky's.
///
///     C = F ((R / A)^q + C∞^q)^(1/q)
///
///     √R = 6.505e-4 B^−¼ − 8.461e-4        C∞ = 7.633e-3 B^−¼ − 7.174e-3        of dark skies
///     √R = 1.772e-4 B^−¼ + 7.167e-5        C∞ = 2.720e-3                        of bright ones
///
/// R is the threshold of a point [sr], C∞ that of a wide field, and q, of 0.6 to 1.1, goes from one to the other.
///
/// Given     sky_cd_m2       B, above 0; held at 1e-5, below which the eye takes a sky for none
///           solid_angle_sr  A, of the light; 6e-5 of the Moon
/// Returned  for a light that is seen half of the time, F times more: 2, of somebody who looks for it outdoors. Of the
///           Moon, 0.6 % of a sky of 100 cd/m², 2.6 % of 0.1 cd/m², as much as the sky of a moonless night
/// Accuracy  F is 1.4 to 2.4 of most observers
/// Source    Crumey (2014), MNRAS 442, 2600, eqs. 23 to 44, after Blackwell (1946) and Taylor (1960)
double contrast_threshold(double sky_cd_m2, double solid_angle_sr);

}  // namespace coppermoon::atmosphere
