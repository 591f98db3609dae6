// SPDX-License-Identifier: MIT
#include "uses/fit/posterior.h"

#include "support/testing.h"

namespace coppermoon::uses::posterior_test {

std::vector<double> evenly(double from, double to, int steps) {
  std::vector<double> all;
  for (int i = 0; i <= steps; ++i) all.push_back(from + (to - from) * i / steps);
  return all;
}

/// Values of a function on a grid, the last axis running fastest.
template <class Function>
std::vector<double> on_grid(const Axes& axes, const Function& function) {
  std::vector<double> all;
  for (const double x : axes[0])
    for (const double y : axes[1])
      for (const double z : axes[2]) all.push_back(function(x, y, z));
  return all;
}

TEST(Posterior, OfANormalDistributionIsItsMeanDeviationAndCorrelation) {
  const Axes axes{evenly(-6, 8, 70), evenly(-4, 4, 60), evenly(0, 30, 60)};
  // x, y with deviations 1 and 0.5 and a correlation of 0.8; z apart from them, deviation 2
  constexpr double r = 0.8, sx = 1, sy = 0.5, sz = 2;
  const auto found = posterior(axes, on_grid(axes, [&](double at_x, double at_y, double at_z) {
                                 const double x = (at_x - 1) / sx, y = (at_y + 0.3) / sy,
                                              z = (at_z - 14) / sz;
                                 return (x * x - 2 * r * x * y + y * y) / (1 - r * r) + z * z + 7;
                               }));
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

TEST(Posterior, OnAFinerGridIsOfARidgeNarrowerThanAStep) {
  // steps of one deviation; across the ridge the deviation is a fifth of that
  constexpr double r = 0.98;
  Axes axes{evenly(-5.3, 4.7, 10), evenly(-4.9, 5.1, 10), evenly(-5.2, 4.8, 10)};
  auto chi_squared = on_grid(axes, [](double x, double y, double z) {
    return (x * x - 2 * r * x * y + y * y) / (1 - r * r) + z * z;
  });
  make_finer(axes, chi_squared);
  const auto found = posterior(axes, chi_squared);
  for (const auto& estimate : found.estimates) {
    EXPECT_WITHIN(estimate.median, 0, 0.01, "a grid of quarter deviations");
    EXPECT_WITHIN((estimate.high - estimate.low) / 2, 1, 0.02,
                  "a density linear between quarter deviations; 0.09 between whole ones");
  }
  EXPECT_WITHIN(found.correlation[0][1], r, 1e-3, "as above");
}

TEST(Posterior, OfNothingSeenIsWhatWasThereBefore) {
  const Axes axes{evenly(0, 1, 20), evenly(-3, -1, 30), evenly(5, 6, 10)};
  const auto found = posterior(axes, on_grid(axes, [](double, double, double) { return 3.; }));
  EXPECT_WITHIN(found.estimates[0].median, 0.5, 1e-12, "rounding");
  EXPECT_WITHIN(found.estimates[0].low, 0.158655, 1e-12, "rounding");
  EXPECT_WITHIN(found.estimates[1].high, -3 + 2 * 0.841345, 1e-12, "rounding");
  EXPECT_WITHIN(found.estimates[2].information, 0, 0.02, "a grid's moments, 1/step^2");
}

TEST(Posterior, AtAnEndStaysWithinIt) {
  const Axes axes{evenly(0, 1, 40), evenly(0, 1, 2), evenly(0, 1, 2)};
  const auto found =
      posterior(axes, on_grid(axes, [](double x, double, double) { return x * x / (0.1 * 0.1); }));
  EXPECT_GE(found.estimates[0].low, 0);
  // half a normal distribution: its median is 0.6745 deviations
  EXPECT_WITHIN(found.estimates[0].median, 0.06745, 0.0025, "a tenth of a step");
}

}  // namespace coppermoon::uses::posterior_test
