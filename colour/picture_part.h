// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "algebra/grid.h"
#include "colour/moon_limb.h"

namespace coppermoon::colour {

/// A rectangle of pixels within a picture.
struct PicturePart {
  std::size_t left, top, columns, rows;
};

/// The square around a disc, clipped to a picture of the given size.
PicturePart window_about(const Disc& disc, std::size_t rows, std::size_t columns);

/// Bins part of a picture by a whole factor along both axes, dropping leftover columns and rows.
///
/// Given  by  the factor, 1 or more
algebra::Grid<float> reduced(const algebra::Grid<float>& picture, const PicturePart& part,
                             std::size_t by);

}  // namespace coppermoon::colour
