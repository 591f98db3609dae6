// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

namespace coppermoon::uses {

/// Axes of a grid over three unknowns. Each axis has increasing values.
using Axes = std::array<std::vector<double>, 3>;

/// Marginal posterior of one unknown.
struct Estimate {
  double median = 0, low = 0, high = 0;  ///< `low` to `high` is the central 68 % interval
  double information = 0;                ///< 1 − posterior variance / prior variance, 0 to 1
};

/// Posterior of three unknowns.
struct Posterior {
  std::array<Estimate, 3> estimates{};
  std::array<std::array<double, 3>, 3> correlation{};
  double least_chi_squared = 0;
};

/// Integrates the posterior over a grid, with a uniform prior.
///
///     p ∝ exp(−χ²/2)
///
/// Given     axes         two or more points on each axis
///           chi_squared  χ² at each point, the last axis running fastest
/// Accuracy  medians and limits: a tenth of a grid step if steps are shorter than half a standard deviation
Posterior posterior(const Axes& axes, const std::vector<double>& chi_squared);

/// Divides each step of a grid into four. Between points, χ² is interpolated along each axis by cubics through the four
/// nearest points. This is exact for a normal distribution, even along a ridge that is narrower than a step.
///
/// Given  axes  with steps no longer than a standard deviation; over longer steps, χ² is not cubic
void make_finer(Axes& axes, std::vector<double>& chi_squared);

}  // namespace coppermoon::uses
