// SPDX-License-Identifier: MIT
#include "uses/fit/posterior.h"

#include <gtest/gtest.h>

#include "support/within.h"

namespace coppermoon::uses {
namespace {

std::vector<double> evenly(double from, double to, int steps) {
  std::vector<double> all;
  for (int i = 0; i <= steps; ++i) all.push_back(from + (to - from) * i / steps);
  return all;
}

TEST(Posterior, OfANormalDistributionIsItsMeanDeviationAndCorrelation) {
  const Axes axes{evenly(-6, 8, 70), evenly(-4, 4, 60), evenly(0, 30, 60)};
  // x, y with deviations 1 and 0.5 and a correlation of 0.8; z apart from them, deviation 2
  constexpr double r = 0.8, sx = 1, sy = 0.5, sz = 2;
  const auto found = posterior(axes, [&](const std::array<std::size_t, 3>& at) {
    const double x = (axes[0][at[0]] - 1) / sx, y = (axes[1][at[1]] + 0.3) / sy,
                 z = (axes[2][at[2]] - 14) / sz;
    return (x * x - 2 * r * x * y + y * y) / (1 - r * r) + z * z + 7;
  });
  const std::array<double, 3> mean{1, -0.3, 14}, deviation{sx, sy, sz}, step{0.2, 8. / 60, 0.5};
  for (std::size_t a = 0; a < 3; ++a) {
    EXPECT_WITHIN(found.estimates[a].median, mean[a], 0.1 * step[a], "Accuracy");
    EXPECT_WITHIN(found.estimates[a].low, mean[a] - deviation[a], 0.1 * step[a], "Accuracy");
    EXPECT_WITHIN(found.estimates[a].high, mean[a] + deviation[a], 0.1 * step[a], "Accuracy");
  }
  EXPECT_WITHIN(found.correlation[0][1], r, 1e-3, "tails beyond six deviations");
  EXPECT_WITHIN(found.correlation[0][2], 0, 1e-9, "rounding");
  EXPECT_GE(found.least_chi_squared, 7);
  EXPECT_LT(found.least_chi_squared, 7.1);
  EXPECT_WITHIN(found.estimates[0].information, 1 - 1 / (14. * 14 / 12), 1e-3, "a grid's moments");
}

TEST(Posterior, OfNothingSeenIsWhatWasThereBefore) {
  const Axes axes{evenly(0, 1, 20), evenly(-3, -1, 30), evenly(5, 6, 10)};
  const auto found = posterior(axes, [](const auto&) { return 3.; });
  EXPECT_WITHIN(found.estimates[0].median, 0.5, 1e-12, "rounding");
  EXPECT_WITHIN(found.estimates[0].low, 0.158655, 1e-12, "rounding");
  EXPECT_WITHIN(found.estimates[1].high, -3 + 2 * 0.841345, 1e-12, "rounding");
  EXPECT_WITHIN(found.estimates[2].information, 0, 0.02, "a grid's moments, 1/step^2");
}

TEST(Posterior, AtAnEndStaysWithinIt) {
  const Axes axes{evenly(0, 1, 40), evenly(0, 1, 2), evenly(0, 1, 2)};
  const auto found = posterior(axes, [&](const auto& at) {
    const double x = axes[0][at[0]] / 0.1;
    return x * x;
  });
  EXPECT_GE(found.estimates[0].low, 0);
  // half a normal distribution: its median is 0.6745 deviations
  EXPECT_WITHIN(found.estimates[0].median, 0.06745, 0.0025, "a tenth of a step");
}

}  // namespace
}  // namespace coppermoon::uses
