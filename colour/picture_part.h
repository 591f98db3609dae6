// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "algebra/grid.h"
#include "colour/limb.h"

namespace coppermoon::colour {

/// A part of a picture.
struct PicturePart {
  std::size_t left, top, columns, rows;
};

/// The square about a disc, as far as it is in a picture of that size.
PicturePart window_about(const Disc& disc, std::size_t rows, std::size_t columns);

/// Means over so many pixels of a part both ways; what is left over at its right and below is left out.
///
/// Given  by  1 or more
algebra::Grid<float> reduced(const algebra::Grid<float>& picture, const PicturePart& part,
                             std::size_t by);

}  // namespace coppermoon::colour
