// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <cstddef>

#include "algebra/grid.h"

namespace coppermoon::colour {

using Spectrum = algebra::Grid<std::complex<double>>;

enum class Direction { forward, back };

/// The smallest length, at least `length`, that is fast to transform because its only prime factors are 2, 3 and 5.
std::size_t quick_length(std::size_t length);

/// Two-dimensional Fourier transform, in place.
///
/// Returned  in `spectrum`, not normalised: transforming forward and back multiplies it by the number of its values
void fourier_transform(Spectrum& spectrum, Direction direction);

}  // namespace coppermoon::colour
