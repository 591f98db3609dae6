// SPDX-License-Identifier: MIT
#include "uses/fit/sky_and_glow.h"

#include "algebra/random.h"
#include "support/testing.h"

namespace coppermoon::uses::sky_and_glow_test {

/// A glow that is brightest beside a crescent.
AroundTheDisc of_a_crescent() {
  AroundTheDisc glow{};
  for (std::size_t i = 0; i < glow.size(); ++i)
    glow[i] = 2 + std::cos(2 * std::numbers::pi * static_cast<double>(i) / 12);
  return glow;
}

AroundTheDisc seen(const AroundTheDisc& glow, double sky, double factor, double noise,
                   algebra::Random& random) {
  AroundTheDisc light{};
  for (std::size_t i = 0; i < light.size(); ++i)
    light[i] = sky + factor * glow[i] + noise * (2 * random.uniform() - 1);
  return light;
}

TEST(SkyAndGlow, AreToldApartByHowTheyRunAroundTheDisc) {
  algebra::Random random(8, 11);
  const auto glow = of_a_crescent();
  auto light = seen(glow, 0.3, 0.05, 0.002, random);
  light[4] += 0.4;  // a star
  const auto found = sky_and_glow(light, glow, {0, 1});
  // a cosine's amplitude from eleven of twelve places: 0.002 / √3 √(2 / 11) = 0.0005
  EXPECT_WITHIN(found.glow.value, 0.05, 0.0015, "three standard errors");
  EXPECT_WITHIN(found.sky.value, 0.3, 0.004, "twice that, and the median's own error");
  EXPECT_GT(found.glow.error, 0.0002);
  EXPECT_LT(found.glow.error, 0.0015);
  EXPECT_LT(found.sky.error, 0.004);
}

TEST(SkyAndGlow, OfAnEvenGlowIsAsExpected) {
  algebra::Random random(8, 12);
  AroundTheDisc even{};
  even.fill(2);
  const auto found = sky_and_glow(seen(even, 0.3, 0.05, 0.002, random), even, {0.04, 0.02});
  constexpr double rounding = 1e-6;  // of differences of sums
  EXPECT_WITHIN(found.glow.value, 0.04, rounding, "nothing is told");
  EXPECT_WITHIN(found.glow.error, 0.02, rounding, "the same");
  EXPECT_WITHIN(found.sky.value, 0.3 + 2 * (0.05 - 0.04), 0.002, "what is left, with its noise");
}

TEST(SkyAndGlow, AreSoundWithoutAnyLight) {
  const auto found = sky_and_glow({}, {}, {0, 1});
  EXPECT_EQ(found.sky.value, 0);
  EXPECT_EQ(found.glow.value, 0);
  EXPECT_TRUE(std::isfinite(found.sky.error));
  EXPECT_EQ(found.glow.error, 1);
}

}  // namespace coppermoon::uses::sky_and_glow_test
