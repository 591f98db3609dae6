// SPDX-License-Identifier: MIT
#pragma once

#include <span>

namespace coppermoon::algebra {

struct QuadratureNode {
  double x, weight;
};

/// Nodes and weights of Gauss–Legendre quadrature on [−1, 1], which is exact for polynomials up to degree 2 count − 1.
///
/// Given   count  number of nodes, 1 to 64
/// Throws  Error  if `count` is out of range
/// Source  Newton's iteration on the Legendre recurrence; Press et al., Numerical Recipes §4.6
std::span<const QuadratureNode> gauss_legendre(int count);

}  // namespace coppermoon::algebra
