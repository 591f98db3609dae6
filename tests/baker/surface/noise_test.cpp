// SPDX-License-Identifier: MIT
#include "surface/noise.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "support/within.h"

namespace {

using namespace coppermoon::surface;

constexpr int count = 20000;

/// Points along a great circle that meets neither poles nor axes.
std::vector<glm::vec3> circle() {
  const auto a = glm::normalize(glm::vec3(1, 2, 3)), b = glm::normalize(glm::vec3(3, 0, -1));
  std::vector<glm::vec3> points;
  for (int i = 0; i < count; ++i) {
    const float t = 6.2831853F * static_cast<float>(i) / count;
    points.push_back(std::cos(t) * a + std::sin(t) * b);
  }
  return points;
}

std::vector<Noise> noise(float frequency) {
  std::vector<Noise> sums(count);
  add_noise(circle(), frequency, {1, 1, 1, 1}, sums);
  return sums;
}

TEST(Noise, StaysWithinItsAmplitudeAndUsesIt) {
  float lowest = 0, highest = 0;
  for (const auto& value : noise(200)) {
    lowest = std::min(lowest, value[2]);
    highest = std::max(highest, value[2]);
  }
  EXPECT_GE(lowest, -1);
  EXPECT_LE(highest, 1);
  EXPECT_GT(highest - lowest, 1.5) << "a thousand cubes come near both ends";
}

TEST(Noise, HasNoMean) {
  double sum = 0;
  for (const auto& value : noise(200)) sum += value[0];
  // About 200 x 2 pi independent cubes of variance below 1/3: four standard errors of their mean.
  EXPECT_WITHIN(sum / count, 0, 4 * std::sqrt(1.0 / 3 / 1257), "four standard errors");
}

TEST(Noise, IsContinuous) {
  const auto values = noise(50);
  const double step = 50 * 6.2831853 / count;
  for (int i = 0; i < count; ++i)
    EXPECT_WITHIN(values[i][1], values[(i + 1) % count][1], 2 * 1.5 * 1.8 * step + 1e-4,
                  "values differ by at most 2, the smooth step's slope is 1.5, along a diagonal");
}

TEST(Noise, ItsFourValuesDiffer) {
  double product = 0, square = 0;
  for (const auto& value : noise(200)) {
    product += value[0] * value[3];
    square += value[0] * value[0];
  }
  EXPECT_WITHIN(product / square, 0, 0.15, "four standard errors of 1257 independent cubes");
}

TEST(Noise, AddsToWhatIsThere) {
  std::vector<Noise> sums(count, Noise{5, 5, 5, 5});
  add_noise(circle(), 20, {0.5F, 0, 0, 0}, sums);
  const auto alone = noise(20);
  for (int i = 0; i < count; i += 997) {
    EXPECT_WITHIN(sums[i][0], 5 + 0.5 * alone[i][0], 1e-6, "floats' rounding");
    EXPECT_EQ(sums[i][1], 5);
  }
}

TEST(Hashed, UnitIntervalIsUniform) {
  std::vector<int> bins(16);
  for (std::int32_t i = 0; i < 16000; ++i)
    ++bins[static_cast<std::size_t>(16 * unit_interval(hashed(i % 40, i / 40 % 20, i / 800, 7)))];
  double chi_squared = 0;
  for (const int n : bins) chi_squared += (n - 1000.0) * (n - 1000.0) / 1000;
  EXPECT_LT(chi_squared, 37.7) << "15 degrees of freedom, one in a thousand";
}

}  // namespace
