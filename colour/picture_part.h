// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "algebra/grid.h"
#include "colour/limb.h"

namespace coppermoon::colour {

/// Rectangle of pixels.
struct PicturePart {
  std::size_t left, top, columns, rows;
};

/// Square about a disc, clipped to a picture of that size.
PicturePart window_about(const Disc& disc, std::size_t rows, std::size_t columns);

/// Part of a picture binned by a whole factor along both axes; leftover columns and rows are left out.
///
/// Given  by  1 or more
algebra::Grid<float> reduced(const algebra::Grid<float>& picture, const PicturePart& part,
                             std::size_t by);

}  // namespace coppermoon::colour
