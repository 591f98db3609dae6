// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "algebra/grid.h"

namespace coppermoon::algebra {

inline constexpr std::size_t points_a_block = 1024;
inline constexpr std::size_t most_dimensions = 6;

/// A block of quasi-random points in the unit cube: the first 1024 points of Sobol's sequence, with Owen's scrambling.
/// Each coordinate has one point in each 1024th of [0, 1), and pairs of coordinates are spread nearly as evenly. Each
/// point by itself is uniformly distributed, and blocks are independent. The mean of a function over a block is
/// therefore unbiased, and its standard error can be estimated from several blocks.
///
/// Given     seed, block  the points depend only on these two numbers, not on the thread
///           dimensions   1 to most_dimensions
/// Returned  coordinates by (point, dimension); point i is in the i-th 1024th of dimension 0
/// Throws    Error  if `dimensions` is out of range
/// Source    Owen (1995), Randomly permuted (t, m, s)-nets and (t, s)-sequences; direction numbers
///           from Joe & Kuo (2008), SIAM J. Sci. Comput. 30, 2635
Grid<double> scrambled_block(std::uint64_t seed, std::uint64_t block, std::size_t dimensions);

}  // namespace coppermoon::algebra
