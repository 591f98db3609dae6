// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

namespace coppermoon::algebra {

/// The i-th of n Chebyshev nodes, which increase between −1 and 1. `chebyshev_series` expects values at these nodes.
double chebyshev_node(int i, int n);

/// Coefficients c_k of the Chebyshev series Σ c_k T_k(x) that takes the given values at the nodes.
///
/// Given  values  one for each node, at least one
std::vector<double> chebyshev_series(std::span<const double> values);

/// Coefficients of a Chebyshev series for each component of a function with several components.
///
/// Given     values  [node][component]
/// Returned  [component][coefficient]
std::vector<std::vector<double>> chebyshev_series(const std::vector<std::vector<double>>& values);

/// Coefficients a_k of the power series Σ a_k x^k that equals a given Chebyshev series.
///
/// Accuracy  rounding errors grow by a factor of about 2.4 with each degree, so that only short series are accurate
std::vector<double> power_series(std::span<const double> chebyshev);

}  // namespace coppermoon::algebra
