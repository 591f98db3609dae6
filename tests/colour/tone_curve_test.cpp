// SPDX-License-Identifier: MIT
#include "colour/tone_curve.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include "colour/measured_tone_curves.h"
#include "support/testing.h"

namespace coppermoon::colour::tone_curve_test {

/// IEC 61966-2-1.
double displayed_at(double level) {
  return level <= 0.04045 ? level / 12.92 : std::pow((level + 0.055) / 1.055, 2.4);
}

/// Scene light at which a measured curve shows that light.
double scene_of(const algebra::MonotoneCubic& curve, double displayed) {
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (curve(middle) < displayed ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// A measured curve's logarithm at levels 0.05 to 0.93, 0 at level 0.5.
struct Logarithms {
  std::vector<double> displayed, logarithm;
};

Logarithms logarithms_of(const MeasuredToneCurve& measured) {
  const auto curve = measured.smooth();
  const auto at = [&](double displayed) {
    return std::log(scene_of(curve, displayed) / displayed);
  };
  const double middle = at(displayed_at(0.5));
  Logarithms all;
  for (int i = 0; i <= 44; ++i) {
    all.displayed.push_back(displayed_at(0.05 + 0.02 * i));
    all.logarithm.push_back(at(all.displayed.back()) - middle);
  }
  return all;
}

/// The three components that come closest.
ToneCurve closest(const Logarithms& seen) {
  glm::dmat3 normal(0);
  glm::dvec3 right(0);
  for (std::size_t i = 0; i < seen.displayed.size(); ++i) {
    const auto derivatives = tone_derivatives(seen.displayed[i]);
    const glm::dvec3 row(derivatives[0], derivatives[1], derivatives[2]);
    normal += glm::outerProduct(row, row);
    right += row * (seen.logarithm[i] - tone_logarithm({}, seen.displayed[i]));
  }
  const auto solved = glm::inverse(normal) * right;
  ToneCurve curve;
  for (std::size_t k = 0; k < 3; ++k) curve.numbers[k] = solved[static_cast<int>(k)];
  return curve;
}

TEST(ToneCurve, OfThreeNumbersComesCloseToCamerasThatItWasNotMadeFrom) {
  const auto measured = measured_tone_curves();
  ASSERT_EQ(measured.size(), 5U);
  double squares = 0, count = 0;
  for (const auto& [camera, curve] : measured) {
    SCOPED_TRACE(camera);
    const auto seen = logarithms_of(curve);
    const auto found = closest(seen);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_LT(std::abs(found.numbers[k]), 2) << "of a number that is 0 ± 1 over cameras";
    for (std::size_t i = 0; i < seen.displayed.size(); ++i, ++count)
      squares += std::pow(seen.logarithm[i] - tone_logarithm(found, seen.displayed[i]), 2);
  }
  EXPECT_LT(std::sqrt(squares / count), 0.025);
}

TEST(ToneCurve, OfTheMeanCameraIsFarFromWhatSrgbSays) {
  // cameras show shadows darker and lights brighter than they are: a step of two stops is three there
  EXPECT_GT(tone_logarithm({}, displayed_at(0.1)), 0.8);
  EXPECT_WITHIN(tone_logarithm({}, displayed_at(128 / 255.)), 0, 1e-6,
                "where curves are pinned; levels have six decimals");
}

TEST(ToneCurve, ChangesAsItsDerivativesSay) {
  ToneCurve curve;
  for (std::size_t k = 0; k < tone_numbers; ++k)
    curve.numbers[k] = 0.3 * static_cast<double>(k % 5);
  for (const double displayed : {0.001, 0.02, 0.2, 0.5, 0.9}) {
    double sum = tone_logarithm({}, displayed);
    for (std::size_t k = 0; k < tone_numbers; ++k)
      sum += curve.numbers[k] * tone_derivatives(displayed)[k];
    EXPECT_WITHIN(tone_logarithm(curve, displayed), sum, 1e-12, "it is linear in its numbers");
  }
}

TEST(ToneCurve, IsFreeInItsToeAndNearlyKnownAbove) {
  // the triangles stand at levels 0.04 + 0.92 j / 15, and add up to 1 between two
  constexpr std::array heights{0.4, 0.1, 0.04, 0.025, 0.025};
  for (std::size_t j = 0; j + 1 < heights.size(); ++j) {
    const double step = 0.92 / 15, level = 0.04 + step * static_cast<double>(j);
    for (const double beyond : {0., 0.25, 0.5}) {
      const auto derivatives = tone_derivatives(displayed_at(level + beyond * step));
      for (std::size_t other = 0; other < tone_levels; ++other)
        EXPECT_WITHIN(derivatives[tone_components + other],
                      other == j       ? heights[j] * (1 - beyond)
                      : other == j + 1 ? heights[j + 1] * beyond
                                       : 0,
                      1e-6, "sRGB's two pieces meet to seven digits")
            << level << " " << other;
    }
  }
  EXPECT_WITHIN(tone_derivatives(displayed_at(0.01))[tone_components], 0.4, 1e-12,
                "below the first");
}

TEST(ToneCurve, TabulatedIsTheSame) {
  ToneCurve curve;
  curve.numbers = {1, -0.5, 0.7};
  const ToneTable table(curve);
  for (const double displayed : {1e-5, 0.003, 0.0131, 0.2, 0.47, 0.848, 1.})
    EXPECT_WITHIN_RELATIVE(double{table(static_cast<float>(displayed))},
                           displayed * std::exp(tone_logarithm(curve, displayed)), 1e-3,
                           "straight lines over a 4096th of the square root");
  EXPECT_EQ(table(-0.01F), -0.01F);
  EXPECT_EQ(table(0), 0);
}

}  // namespace coppermoon::colour::tone_curve_test
