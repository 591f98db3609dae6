// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/quantity.h"

namespace coppermoon::uses {

/// Luminance of moonlight that a clear sky scatters, at the zenith [cd/m²].
///
///     B = f(ρ) 10^(−0.4 (m + 16.57)) 10^(−0.4 k X) (1 − 10^(−0.4 k)) nL
///     f = 10^5.36 (1.06 + cos²ρ) + 10^(6.15 − ρ/40°)        X = (1 − 0.96 sin²ρ)^−½
///
/// with ρ the Moon's zenith distance, k = 0.172 and 1 nL = 10⁻⁵/π cd/m².
///
/// Given     moon_magnitude  V, above the air
/// Returned  0 for a Moon below the horizon
/// Accuracy  8 to 23 %, of the formula
/// Source    Krisciunas & Schaefer (1991), PASP 103, 1033
double moonlit_sky_cd_m2(double moon_magnitude, algebra::Angle moon_altitude);

/// V magnitude of the faintest star that the naked eye sees near the zenith.
///
///     7.93 − 5 lg(1 + 10^(4.316 − B/5))        B: the sky's magnitude for each square arc second
///
/// Given     sky_cd_m2  luminance of the sky, above 0
/// Accuracy  0.5 between observers
/// Source    Schaefer (1990), PASP 102, 212, after Knoll, Tousey & Hulburt (1946)
double faintest_star(double sky_cd_m2);

}  // namespace coppermoon::uses
