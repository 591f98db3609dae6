// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "algebra/grid.h"
#include "colour/moon_limb.h"

namespace coppermoon::colour {

/// In a small picture, finds circles with many edges along them and with light that decreases outward. It looks for one
/// circle with each of four tone curves, from one that shows the dimmest limb to one that shows only the brightest.
///
/// Given     image  a few hundred pixels on each side; values on any scale
/// Returned  up to four circles, accurate to 1.5 pixels, with radii of 5 pixels or more; in no particular order
std::vector<Disc> likely_circles(const algebra::Grid<float>& image);

}  // namespace coppermoon::colour
