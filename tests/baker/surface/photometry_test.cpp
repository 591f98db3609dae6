// SPDX-License-Identifier: MIT
#include "surface/photometry.h"

#include "support/within.h"

namespace {

using namespace coppermoon::surface;

TEST(RadianceFactor, IsOneWhereLightFallsStraightDown) {
  EXPECT_WITHIN(radiance_factor_yapo_cutler(1), 1, 1e-15, "1 / (0.1 + 0.9), but for rounding");
}

TEST(RadianceFactor, FollowsItsEquation) {
  // 0.5 / 0.55 and 0.1 / 0.19: flat over most of the disc, half as bright only 6 degrees from the
  // limb.
  EXPECT_WITHIN(radiance_factor_yapo_cutler(0.5), 0.9090909090909091, 1e-15, "closed form");
  EXPECT_WITHIN(radiance_factor_yapo_cutler(0.1), 0.5263157894736842, 1e-15, "closed form");
}

TEST(RadianceFactor, IsDarkOnTheNightSide) {
  EXPECT_EQ(radiance_factor_yapo_cutler(0), 0);
  EXPECT_EQ(radiance_factor_yapo_cutler(-0.5), 0);
}

TEST(RadianceFactor, HasTheDiscMeanOfItsClosedForm) {
  double sum = 0;
  const int n = 100000;
  for (int i = 0; i < n; ++i) {
    const double mu = (i + 0.5) / n;
    sum += 2 * mu * radiance_factor_yapo_cutler(mu) / n;
  }
  EXPECT_WITHIN(radiance_factor_yapo_cutler_disc_mean(), sum, 1e-9, "midpoint rule of 1e5 steps");
  EXPECT_WITHIN(radiance_factor_yapo_cutler_disc_mean(), 0.92737, 5e-6, "the docstring's digits");
}

}  // namespace
