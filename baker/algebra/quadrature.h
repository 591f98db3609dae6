// SPDX-License-Identifier: MIT
#pragma once

#include <span>

namespace coppermoon::algebra {

struct QuadratureNode {
  double x, weight;
};

/// Gauss–Legendre nodes on [-1, 1], exact for polynomials of degree up to 2 count − 1.
///
/// Given   count  1 to 64
/// Throws  Error  if `count` is out of range
/// Source  Newton's iteration on the Legendre recurrence; Press et al., Numerical Recipes §4.6
std::span<const QuadratureNode> gauss_legendre(int count);

}  // namespace coppermoon::algebra
