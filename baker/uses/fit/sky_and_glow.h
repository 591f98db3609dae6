// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "algebra/grid.h"

namespace coppermoon::uses {

/// Side of a scene's picture, to which photographs are resampled, and the ratio of the disc's diameter to it.
inline constexpr std::size_t fit_side_px = 320;
inline constexpr double fit_disc_share = 0.8;

/// Means of a scene's picture in twelve sectors of the ring from 1.12 to 1.24 disc radii.
using AroundTheDisc = std::array<double, 12>;

/// Means of a picture around the disc.
AroundTheDisc around_the_disc(const algebra::Grid<float>& picture);

/// Median over the sectors.
double median_of(AroundTheDisc around);

/// A value and its standard error.
struct Uncertain {
  double value = 0, error = 0;
};

/// Light beside the disc: uniform light from the sky, and a factor on the computed glow.
struct SkyAndGlow {
  Uncertain sky, glow;
};

/// Separates sky and glow by how the glow varies around the disc, using robust least squares with Tukey's biweight,
/// which rejects stars.
///
/// Given     light   around the disc
///           glow    computed glow around the disc
///           factor  prior of the factor on the glow
/// Returned  the sky's error is the spread of what remains; the glow's factor is 0 or more
SkyAndGlow sky_and_glow(const AroundTheDisc& light, const AroundTheDisc& glow,
                        const Uncertain& factor);

}  // namespace coppermoon::uses
