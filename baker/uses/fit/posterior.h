// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <vector>

namespace coppermoon::uses {

/// Three unknowns, each on a grid of its own, increasing.
using Axes = std::array<std::vector<double>, 3>;

/// One of three unknowns, as far as it is known.
struct Estimate {
  double median = 0, low = 0, high = 0;  ///< low to high: the middle 68 % of the probability
  double information = 0;  ///< 1 − its variance over that before anything was seen: 0 to 1
};

/// All three unknowns, as far as they are known.
struct Posterior {
  std::array<Estimate, 3> estimates{};
  std::array<std::array<double, 3>, 3> correlation{};
  double least_chi_squared = 0;
};

/// Probabilities over a grid, summed up; all values of an axis are as likely before.
///
///     p ∝ exp(−χ²/2)
///
/// Given     axes         two points or more on each
///           chi_squared  χ² at a point, by its indices on the three axes
/// Accuracy  medians and limits: a tenth of a grid's step where a step is less than half of the
///           standard deviation
Posterior posterior(const Axes& axes,
                    const std::function<double(const std::array<std::size_t, 3>&)>& chi_squared);

}  // namespace coppermoon::uses
