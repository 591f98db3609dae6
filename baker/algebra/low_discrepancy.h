// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "algebra/grid.h"

namespace coppermoon::algebra {

inline constexpr std::size_t points_a_block = 1024;
inline constexpr std::size_t most_dimensions = 6;

/// A block of points of the unit cube, spread more evenly than chance does: Sobol's first 1024,
/// scrambled as Owen has it. Every coordinate has one point in each 1024th of [0, 1), every two of
/// them nearly as evenly; each point by itself is uniform, and blocks are independent of each
/// other: the mean over a block of any function is without bias, and blocks give its standard
/// error.
///
/// Given     seed, block  the same points whichever thread asks; dimensions: 1 to most_dimensions
/// Returned  (point, dimension); point i is in the i-th 1024th of dimension 0
/// Throws    Error  when dimensions is outside its range
/// Source    Owen (1995), Randomly permuted (t, m, s)-nets and (t, s)-sequences; direction numbers
///           of Joe & Kuo (2008), SIAM J. Sci. Comput. 30, 2635
Grid<double> scrambled_block(std::uint64_t seed, std::uint64_t block, std::size_t dimensions);

}  // namespace coppermoon::algebra
