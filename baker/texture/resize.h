// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "algebra/grid.h"

namespace coppermoon::texture {

/// Weighted range of neighbouring texels in a line of the map; those between `first` and `last` have equal weight.
struct LineShare {
  std::size_t first, last;
  double first_part, last_part;
};

/// An albedo map at another size, a row at a time. Smaller: the mean over each texel's area;
/// larger: bilinear, as surface::sampled; the same: the map itself.
class ResizedRows {
 public:
  /// Given   map   2:1; it must outlive this
  ///         rows  2 to 16384; twice as many columns
  /// Throws  Error when rows or the map's shape is outside what is allowed
  ResizedRows(const algebra::Grid<float>& map, std::size_t rows);

  std::size_t rows() const { return rows_; }

  /// Given     buffer  where the row may be made
  /// Returned  the row: in the buffer or in the map
  std::span<const float> row(std::size_t row, std::vector<float>& buffer) const;

 private:
  const algebra::Grid<float>* map_;
  std::size_t rows_;
  std::vector<LineShare> columns_;
};

/// The whole map at another size.
algebra::Grid<float> resized(const algebra::Grid<float>& map, std::size_t rows);

}  // namespace coppermoon::texture
