// SPDX-License-Identifier: MIT
#include "algebra/interpolation.h"

#include "support/testing.h"

namespace coppermoon::algebra::interpolation_test {

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

TEST(OnLine, TellsThePointsOnEitherSide) {
  for (const auto& [at, below, above, further] :
       {std::tuple{1., 0U, 1U, 0.}, {3.5, 1U, 2U, 0.75}, {4., 2U, 3U, 0.}}) {
    const auto found = on_line(x, at);
    EXPECT_EQ(found.below, below) << at;
    EXPECT_EQ(found.above, above) << at;
    EXPECT_EQ(found.further, further) << at;
  }
}

TEST(OnLine, IsAnEndOutside) {
  for (const auto& [at, end] : {std::pair{0.9, 0U}, {5., 3U}, {1e9, 3U}}) {
    const auto found = on_line(x, at);
    EXPECT_EQ(found.below, end) << at;
    EXPECT_EQ(found.above, end) << at;
    EXPECT_EQ(found.further, 0) << at;
  }
}

TEST(OnPolynomial, IsExactForACubicThroughFourNodes) {
  const auto cubic = [](double at) { return 2 * at * at * at - at + 3; };
  for (const double at : {0., 1., 3.3, 7.}) {
    const auto counts = on_polynomial(std::span(x), at);
    double sum = 0, value = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      sum += counts[i];
      value += counts[i] * cubic(x[i]);
    }
    EXPECT_WITHIN(sum, 1., 1e-13, "rounding");
    EXPECT_WITHIN_RELATIVE(value, cubic(at), 1e-13, "rounding");
  }
}

TEST(OnPolynomial, IsTheSameOfANumberOfNodesThatIsKnownLate) {
  const auto early = on_polynomial(std::span(x), 3.3);
  EXPECT_TRUE(std::ranges::equal(on_polynomial(std::span<const double>(x), 3.3), early));
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

TEST(MonotoneCubic, PassesThroughItsPoints) {
  const MonotoneCubic curve(x, y);
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_WITHIN(curve(x[i]), y[i], 1e-14, "rounding");
}

TEST(MonotoneCubic, IsAStraightLineThroughPointsOfOne) {
  constexpr std::array on_line{3.0, 5.0, 9.0, 11.0};
  const MonotoneCubic line(x, on_line);
  for (double at = -2; at < 9; at += 0.25) EXPECT_WITHIN(line(at), 1 + 2 * at, 1e-14, "rounding");
}

TEST(MonotoneCubic, NeverLeavesTheRangeOfItsNeighbours) {
  constexpr std::array steep{0.0, 1e-6, 1e-5, 1.0};
  const MonotoneCubic curve(x, steep);
  for (double at = 1; at < 4.99; at += 0.01) EXPECT_GE(curve(at + 0.01), curve(at)) << at;
  const MonotoneCubic jagged(x, y);
  for (double at = 1; at <= 5; at += 0.01) {
    EXPECT_LE(jagged(at), 30);
    EXPECT_GE(jagged(at), -10);
  }
}

TEST(MonotoneCubic, HasASlopeWithoutJumps) {
  constexpr std::array rising{0.0, 1.0, 7.0, 8.0};
  const MonotoneCubic curve(x, rising);
  constexpr double step = 1e-6;
  for (const double at : x) {
    const double left = (curve(at) - curve(at - step)) / step;
    const double right = (curve(at + step) - curve(at)) / step;
    EXPECT_WITHIN(left, right, 2e-5, "the step times a second derivative of at most 10") << at;
  }
}

TEST(OnCircle, IsTheCubicThroughTwoValuesOnEitherSide) {
  constexpr std::size_t count = 12;
  for (double turn = 0; turn <= count; turn += 0.125) {
    const auto some = on_circle(count, turn);
    double sum = 0, place = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const double after = std::remainder(static_cast<double>(some.at[i]) - turn, count);
      sum += some.share[i];
      place += some.share[i] * after * after * after;
      EXPECT_LE(std::abs(after), 2) << turn;
    }
    EXPECT_WITHIN(sum, 1., 1e-15, "rounding");
    EXPECT_WITHIN(place, 0., 1e-14, "rounding: a cubic's own") << turn;
  }
}

TEST(OnCircle, OfOneValueIsThatAlone) {
  const auto all = on_circle(1, 0.7);
  EXPECT_EQ(all.at, (std::array<std::size_t, 4>{}));
  EXPECT_EQ(all.share, (std::array<double, 4>{1}));
}

// At 2 between secants 1 (one wide) and 3 (two wide): 3·3/((2·2 + 1)/1 + (2 + 2·1)/3) = 27/19.
TEST(MonotoneCubic, HasTheSlopeOfFritschAndButland) {
  constexpr std::array rising{0.0, 1.0, 7.0, 8.0};
  const MonotoneCubic curve(x, rising);
  EXPECT_WITHIN((curve(2 + 1e-5) - curve(2 - 1e-5)) / 2e-5, 27.0 / 19, 1e-4,
                "the step times a jump of the second derivative of at most 10");
}

// Errors shrink as the square of the step at least, for a rising curve.
TEST(MonotoneCubic, ConvergesToWhatItSamples) {
  const auto worst = [](int pieces) {
    std::vector<double> at, sine;
    for (int i = 0; i <= pieces; ++i) at.push_back(1.5 * i / pieces);
    for (const double a : at) sine.push_back(std::sin(a));
    const MonotoneCubic curve(at, sine);
    double error = 0;
    for (double a = 0; a < 1.5; a += 0.001)
      error = std::max(error, std::abs(curve(a) - std::sin(a)));
    return error;
  };
  EXPECT_LT(worst(15), 1e-3);
  EXPECT_LT(worst(60), worst(15) / 12);
}

TEST(MonotoneCubic, FindsItsPieceAmongVeryUnequalOnes) {
  const std::vector<double> at{0, 0.3, 1, 1.1, 7, 7.5, 100}, value{0, 1, 2, 3, 5, 8, 9};
  const MonotoneCubic curve(at, value);
  for (std::size_t i = 0; i + 1 < at.size(); ++i)
    for (const double share : {1e-9, 0.1, 0.5, 0.9, 1 - 1e-9}) {
      const double found = curve(at[i] + share * (at[i + 1] - at[i]));
      EXPECT_GE(found, value[i]);
      EXPECT_LE(found, value[i + 1]);
    }
}

}  // namespace coppermoon::algebra::interpolation_test
