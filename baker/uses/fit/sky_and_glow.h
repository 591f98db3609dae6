// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "algebra/grid.h"

namespace coppermoon::uses {

/// Picture of a scene, to which photographs are resampled: its side, and the disc's diameter over it.
inline constexpr std::size_t fit_side_px = 320;
inline constexpr double fit_disc_share = 0.8;

/// Means of such a picture in twelve sectors of the ring from 1.12 to 1.24 radii of the disc.
using AroundTheDisc = std::array<double, 12>;

/// Means of a picture around the disc.
AroundTheDisc around_the_disc(const algebra::Grid<float>& picture);

/// Median of the sectors.
double median_of(AroundTheDisc around);

/// A value and its standard error.
struct Uncertain {
  double value = 0, error = 0;
};

/// Light beside the disc: the sky's, uniform, and a factor on the computed glow.
struct SkyAndGlow {
  Uncertain sky, glow;
};

/// Separates sky and glow by the glow's variation around the disc: robust least squares with Tukey's biweight, which
/// rejects stars.
///
/// Given     light   around the disc
///           glow    computed, around the disc
///           factor  prior of the factor on the glow
/// Returned  the sky's error is the spread of what remains; the glow's factor is 0 or more
SkyAndGlow sky_and_glow(const AroundTheDisc& light, const AroundTheDisc& glow,
                        const Uncertain& factor);

}  // namespace coppermoon::uses
