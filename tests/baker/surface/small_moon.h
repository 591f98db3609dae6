// SPDX-License-Identifier: MIT
// The built-in map at a size that tests can sum over.
#pragma once

#include <cstddef>

#include "surface/built_in_map.h"

namespace coppermoon::surface {

/// Means over squares of the built-in map's texels.
///
/// Given  rows  a divisor of its 2048
inline algebra::Grid<float> small_moon(std::size_t rows) {
  const auto map = built_in_map();
  const std::size_t n = map.rows() / rows;
  algebra::Grid<float> small(rows, 2 * rows, 0);
  for (std::size_t r = 0; r < map.rows(); ++r)
    for (std::size_t c = 0; c < map.columns(); ++c)
      small(r / n, c / n) += map(r, c) / static_cast<float>(n * n);
  return small;
}

}  // namespace coppermoon::surface
