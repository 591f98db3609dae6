// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "algebra/grid.h"
#include "colour/moon_limb.h"

namespace coppermoon::colour {

/// Finds circles along which many edges in a small picture lie, with light falling outward. There is one for each of
/// four tone curves, from one that shows the dimmest limb to one that shows only the brightest.
///
/// Given     image  a few hundred pixels a side, of any scale
/// Returned  circles correct to 1.5 pixels, with radii of 5 pixels or more; in no particular order
std::vector<Disc> likely_circles(const algebra::Grid<float>& image);

}  // namespace coppermoon::colour
