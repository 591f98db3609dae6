// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <cstddef>

#include "algebra/grid.h"

namespace coppermoon::colour {

using Spectrum = algebra::Grid<std::complex<double>>;

enum class Direction { forward, back };

/// The next length that transforms are quick for: only 2, 3 and 5 divide it.
std::size_t quick_length(std::size_t length);

/// Fourier transform of rows and columns, in place.
///
/// Returned  without a factor: there and back is the grid times the number of its values
void fourier_transform(Spectrum& spectrum, Direction direction);

}  // namespace coppermoon::colour
