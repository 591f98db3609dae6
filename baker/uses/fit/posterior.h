// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

namespace coppermoon::uses {

/// Grid over three unknowns: increasing values of each.
using Axes = std::array<std::vector<double>, 3>;

/// Marginal posterior of one unknown.
struct Estimate {
  double median = 0, low = 0, high = 0;  ///< low to high: the central 68 % interval
  double information = 0;                ///< 1 − posterior variance over prior variance: 0 to 1
};

/// Posterior of three unknowns.
struct Posterior {
  std::array<Estimate, 3> estimates{};
  std::array<std::array<double, 3>, 3> correlation{};
  double least_chi_squared = 0;
};

/// Integrates the posterior over a grid; the prior is uniform.
///
///     p ∝ exp(−χ²/2)
///
/// Given     axes         two points or more on each
///           chi_squared  χ² at each point, the last axis running fastest
/// Accuracy  medians and limits: a tenth of a grid step where steps are below half a standard deviation
Posterior posterior(const Axes& axes, const std::vector<double>& chi_squared);

/// Divides each step of a grid by four. Between its points χ² is interpolated by the cubic polynomial through the four
/// nearest on an axis: exact for a normal distribution, also along a ridge that is narrower than a step.
///
/// Given  steps within a standard deviation: elsewhere χ² is no cubic polynomial
void make_finer(Axes& axes, std::vector<double>& chi_squared);

}  // namespace coppermoon::uses
