// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "atmosphere/observer_air.h"

namespace coppermoon::uses {

/// Temperature of a black body of a star's colour [K].
///
///     4600 (1 / (0.92 (B − V) + 1.7) + 1 / (0.92 (B − V) + 0.62))
///
/// Given   b_minus_v  −0.5 to 4, held at either end
/// Source  Ballesteros (2012), EPL 97, 34008, equation 14
double star_temperature_k(double b_minus_v);

/// Light of a star on a surface that faces it: linear Rec.709 [lux].
///
/// It has the spectrum of a black body, and as much of it as the V magnitude says, by the Sun's (see
/// photometric_bands): a white star of V = 0 gives 2.6e-6 lux.
///
/// Given     sightline  through the air above an observer, which reddens and dims it; none: above the
///                      air
/// Accuracy  0.02 magnitude of luminance; colours as far as stars are black bodies
std::array<double, 3> star_light_lux(double magnitude, double b_minus_v,
                                     const std::optional<atmosphere::Sightline>& sightline = {});

}  // namespace coppermoon::uses
