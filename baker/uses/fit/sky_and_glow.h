// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "algebra/grid.h"

namespace coppermoon::uses {

/// The picture that photographs are brought to: its side, and the Moon's share of it.
inline constexpr std::size_t fit_side_px = 320;
inline constexpr double fit_disc_share = 0.8;

/// Means of such a picture's sky beside the disc, from 1.12 to 1.24 of its radius, in twelve parts of the
/// circle.
using AroundTheDisc = std::array<double, 12>;
AroundTheDisc around_the_disc(const algebra::Grid<float>& picture);

/// The middle one of them.
double median_of(AroundTheDisc around);

/// A value and its standard error.
struct Uncertain {
  double value = 0, error = 0;
};

/// Light beside the disc: the sky's, even; and a glow's, a factor on what was computed of it.
struct SkyAndGlow {
  Uncertain sky, glow;
};

/// Tells them apart by how the light runs around the disc: least squares, without outliers as stars are.
///
/// Given     light   around the disc
///           glow    what was computed of a glow there
///           factor  on it, as expected before the light is seen
/// Returned  the sky's error: what remains uneven; the glow's factor 0 or more
SkyAndGlow sky_and_glow(const AroundTheDisc& light, const AroundTheDisc& glow,
                        const Uncertain& factor);

}  // namespace coppermoon::uses
