// SPDX-License-Identifier: MIT
#pragma once

namespace coppermoon::uses {

/// V magnitude of the faintest star that the naked eye sees near the zenith.
///
///     7.93 − 5 lg(1 + 10^(4.316 − B/5))        B: the sky's magnitude for each square arc second
///
/// Given     sky_cd_m2  luminance of the sky, above 0
/// Accuracy  0.5 between observers
/// Source    Schaefer (1990), PASP 102, 212, after Knoll, Tousey & Hulburt (1946)
double faintest_star(double sky_cd_m2);

}  // namespace coppermoon::uses
