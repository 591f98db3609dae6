// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "algebra/grid.h"
#include "colour/limb.h"

namespace coppermoon::colour {

/// Circles on which many edges of a small picture lie, light falling outward: one for each of four tone
/// curves, from one that shows the dimmest limb to one that shows only the brightest.
///
/// Given     image  some hundred pixels a side, of any scale
/// Returned  within 1.5 pixels, of 5 pixels' radius or more; in no order
std::vector<Disc> likely_circles(const algebra::Grid<float>& image);

}  // namespace coppermoon::colour
