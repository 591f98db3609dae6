// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

namespace coppermoon::algebra {

/// Position of the i-th of n Chebyshev nodes, at which `chebyshev_series` takes its values. They increase from −1 to 1.
double chebyshev_node(int i, int n);

/// Coefficients c of the Chebyshev series Σ c_k T_k that passes through the values at all nodes.
///
/// Given  values  [node], one or more
std::vector<double> chebyshev_series(std::span<const double> values);

/// The coefficients of the Chebyshev series for a function with several components.
///
/// Given     values  [node][component]
/// Returned  [component][coefficient]
std::vector<std::vector<double>> chebyshev_series(const std::vector<std::vector<double>>& values);

/// Coefficients a of the power series Σ a_k x^k that equals a Chebyshev series.
///
/// Accuracy  rounding errors grow by a factor of about 2.4 with each degree, so use it for few coefficients only
std::vector<double> power_series(std::span<const double> chebyshev);

}  // namespace coppermoon::algebra
