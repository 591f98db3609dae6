// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "algebra/grid.h"

namespace coppermoon::uses {

/// Side of the square picture to which photographs are resampled [pixels], and share of the side that the disc spans.
inline constexpr std::size_t fit_side_px = 320;
inline constexpr double fit_disc_share = 0.8;

/// Mean values of a scene's picture in twelve sectors of a ring around the disc, from 1.12 to 1.24 disc radii.
using AroundTheDisc = std::array<double, 12>;

/// Mean values of a picture in the sectors around the disc.
AroundTheDisc around_the_disc(const algebra::Grid<float>& picture);

double median_of(AroundTheDisc around);

/// A value and its standard error.
struct Uncertain {
  double value = 0, error = 0;
};

/// Model of the light beside the disc: uniform light `sky`, plus the computed glow multiplied by the factor `glow`.
struct SkyAndGlow {
  Uncertain sky, glow;
};

/// Separates the light beside the disc into sky and glow, by how the glow varies around the disc. A robust fit with
/// Tukey's biweight rejects stars.
///
/// Given     light   measured light around the disc
///           glow    computed glow around the disc
///           factor  prior of the factor on the glow
/// Returned  sky, whose error is the spread of the residuals, and a factor of 0 or more on the glow
SkyAndGlow sky_and_glow(const AroundTheDisc& light, const AroundTheDisc& glow,
                        const Uncertain& factor);

}  // namespace coppermoon::uses
