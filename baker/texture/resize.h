// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "algebra/grid.h"

namespace coppermoon::texture {

/// Range of texels in a row or column of the map, with weights. All texels between `first` and `last` weigh the same.
struct LineShare {
  std::size_t first, last;
  double first_part, last_part;
};

/// An albedo map at another size, made row by row. A smaller map has the mean over each texel's area. A larger one is
/// interpolated bilinearly, as in surface::sampled. At the same size it is the map itself.
class ResizedRows {
 public:
  /// Given   map   albedo map, 2:1; must outlive this object
  ///         rows  number of rows, 2 to 16384; there are twice as many columns
  /// Throws  Error when `rows` is out of range or the map is not 2:1
  ResizedRows(const algebra::Grid<float>& map, std::size_t rows);

  std::size_t rows() const { return rows_; }

  /// Given     buffer  memory in which the row may be computed
  /// Returned  the row, which lies in the buffer or in the map
  std::span<const float> row(std::size_t row, std::vector<float>& buffer) const;

 private:
  const algebra::Grid<float>* map_;
  std::size_t rows_;
  std::vector<LineShare> columns_;
};

/// Resizes a whole albedo map to the given number of rows.
algebra::Grid<float> resized(const algebra::Grid<float>& map, std::size_t rows);

}  // namespace coppermoon::texture
