// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <vector>

namespace coppermoon::verbs {

/// Three unknowns, each on a grid of its own, increasing.
using Axes = std::array<std::vector<double>, 3>;

/// One of them, once seen.
struct Estimate {
  double median = 0, low = 0, high = 0;  ///< low to high: the middle 68 % of the probability
  double told = 0;  ///< 1 − its variance over that before anything was seen: 0 when nothing is told
};

/// What is known of all three.
struct Posterior {
  std::array<Estimate, 3> estimates{};
  std::array<double, 3> best{};  ///< where it is most probable
  std::array<std::array<double, 3>, 3> correlation{};
  double least_chi_squared = 0;
};

/// Each probability as the grid has it, all values of an axis as likely before.
///
///     p ∝ exp(−χ²/2)
///
/// Given     chi_squared  of the indices on the three axes, two points or more each
/// Accuracy  medians and limits: a tenth of a grid's step where a step is less than half of the
///           standard deviation
Posterior posterior(const Axes& axes,
                    const std::function<double(const std::array<std::size_t, 3>&)>& chi_squared);

}  // namespace coppermoon::verbs
