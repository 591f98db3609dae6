// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

/// Σ (seen − expected)² / expected over bins that are all equally likely.
inline double chi_squared(std::span<const int> seen) {
  double total = 0, sum = 0;
  for (const int n : seen) total += n;
  const double expected = total / static_cast<double>(seen.size());
  for (const int n : seen) sum += (n - expected) * (n - expected) / expected;
  return sum;
}

/// Where chi² lies for a true sampler but for one run in a thousand, half of it at either end:
/// the 0.0005 and 0.9995 quantiles for as many degrees of freedom.
struct ChiSquaredBounds {
  double lowest, highest;
};
inline constexpr ChiSquaredBounds chi_squared_of_49{22.79, 88.23};
inline constexpr ChiSquaredBounds chi_squared_of_99{59.13, 151.93};
inline constexpr ChiSquaredBounds chi_squared_of_255{187.17, 335.92};

/// Passes a true sampler in 999 runs of 1000; the seeds are fixed.
#define EXPECT_UNIFORM(seen, bounds)           \
  EXPECT_GT(chi_squared(seen), bounds.lowest); \
  EXPECT_LT(chi_squared(seen), bounds.highest)
