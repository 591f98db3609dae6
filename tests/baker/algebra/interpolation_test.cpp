// SPDX-License-Identifier: MIT
#include "algebra/interpolation.h"

#include <gtest/gtest.h>

#include <array>

#include "support/within.h"

namespace coppermoon::algebra {
namespace {

constexpr std::array x{1.0, 2.0, 4.0, 5.0};
constexpr std::array y{10.0, 30.0, -10.0, 0.0};

TEST(Interpolated, PassesThroughItsPoints) {
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_EQ(interpolated(x, y, x[i]), y[i]);
}

TEST(Interpolated, IsStraightBetweenPoints) {
  EXPECT_WITHIN(interpolated(x, y, 1.25), 15.0, 1e-14, "rounding");
  EXPECT_WITHIN(interpolated(x, y, 3.0), 10.0, 1e-14, "rounding");
  EXPECT_WITHIN(interpolated(x, y, 4.9), -1.0, 1e-14, "rounding");
}

TEST(Interpolated, HoldsTheEndValuesOutside) {
  EXPECT_EQ(interpolated(x, y, -1e9), 10);
  EXPECT_EQ(interpolated(x, y, 1e9), 0);
}

TEST(Interpolated, IsConstantThroughASinglePoint) {
  constexpr std::array one{7.0};
  EXPECT_EQ(interpolated(one, one, 6), 7);
  EXPECT_EQ(interpolated(one, one, 8), 7);
}

// Trapezia by hand: 20, then 20 (30 to −10 over 2), then −5.
TEST(MeanBetween, IsTheAreaOverTheWidth) {
  EXPECT_WITHIN(mean_between(x, y, 1, 5), (20.0 + 20 - 5) / 4, 1e-14, "rounding");
  EXPECT_WITHIN(mean_between(x, y, 1.5, 3), (12.5 + 20) / 1.5, 1e-14, "rounding");
}

TEST(MeanBetween, OfANarrowPieceIsTheValueAtItsMiddle) {
  EXPECT_WITHIN(mean_between(x, y, 2.5, 2.75), interpolated(x, y, 2.625), 1e-13, "rounding");
}

TEST(MeanBetween, HoldsTheEndValuesOutside) {
  EXPECT_WITHIN(mean_between(x, y, -9, -5), 10.0, 1e-14, "rounding");
  EXPECT_WITHIN(mean_between(x, y, 8, 9), 0.0, 1e-14, "rounding");
  EXPECT_WITHIN(mean_between(x, y, -3, 5), (40.0 + 35) / 8, 1e-14, "rounding");
  EXPECT_WITHIN(mean_between(x, y, 1, 11), 35.0 / 10, 1e-14, "rounding");
}

TEST(MeanBetween, OfNeighboursAddsUpToThatOfTheWhole) {
  double sum = 0;
  for (int i = 0; i < 40; ++i) sum += 0.1 * mean_between(x, y, 1 + 0.1 * i, 1 + 0.1 * (i + 1));
  EXPECT_WITHIN(sum, 35.0, 1e-12, "rounding");
}

}  // namespace
}  // namespace coppermoon::algebra
