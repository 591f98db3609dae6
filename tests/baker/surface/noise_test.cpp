// SPDX-License-Identifier: MIT
#include "surface/noise.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "support/within.h"

namespace {

using namespace coppermoon::surface;

constexpr std::size_t count = 20000;

/// Points along a great circle that meets neither poles nor axes, coordinate by coordinate.
std::array<std::vector<float>, 3> circle() {
  const auto a = glm::normalize(glm::vec3(1, 2, 3)), b = glm::normalize(glm::vec3(3, 0, -1));
  std::array<std::vector<float>, 3> points;
  for (std::size_t i = 0; i < count; ++i) {
    const float t = 6.2831853F * static_cast<float>(i) / count;
    const auto point = std::cos(t) * a + std::sin(t) * b;
    for (int k = 0; k < 3; ++k) points[static_cast<std::size_t>(k)].push_back(point[k]);
  }
  return points;
}

using Values = std::array<std::vector<float>, 4>;

Values noise(float frequency, const std::array<float, 4>& amplitude = {1, 1, 1, 1},
             float before = 0) {
  const auto points = circle();
  Values sums;
  sums.fill(std::vector<float>(count, before));
  add_noise({points[0], points[1], points[2]}, frequency, amplitude,
            {sums[0], sums[1], sums[2], sums[3]});
  return sums;
}

/// One value by the definition.
double one(const std::array<float, 3>& point, float frequency, std::size_t k) {
  const std::array p{0.36F * point[0] + 0.48F * point[1] - 0.8F * point[2],
                     -0.8F * point[0] + 0.6F * point[1],
                     0.48F * point[0] + 0.64F * point[1] + 0.6F * point[2]};
  double sum = 0;
  for (int i = 0; i < 8; ++i) {
    double weight = 1;
    std::array<std::int32_t, 3> at{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double place = double{p[axis]} * frequency, t = place - std::floor(place);
      const double far = t * t * (3 - 2 * t);
      const int step = i >> axis & 1;
      weight *= step == 1 ? far : 1 - far;
      at[axis] = static_cast<std::int32_t>(std::floor(place)) + step;
    }
    const auto hash = hashed(at[0], at[1], at[2], static_cast<std::uint32_t>(frequency * 16));
    sum += weight * (static_cast<double>(hash >> (16 * k) & 0xFFFF) * 2 / 65535 - 1);
  }
  return sum;
}

TEST(Noise, IsTheMeanOfTheCornersByTheirHashes) {
  const auto points = circle();
  for (const float frequency : {3.F, 48.F, 384.F, 1536.F}) {
    const auto values = noise(frequency);
    for (std::size_t i = 0; i < count; i += 7)
      for (std::size_t k = 0; k < 4; ++k)
        EXPECT_WITHIN(values[k][i], one({points[0][i], points[1][i], points[2][i]}, frequency, k),
                      3 * frequency * 3e-7 + 1e-6, "floats' rounding of a place in its cube")
            << frequency << " " << i;
  }
}

TEST(Noise, StaysWithinItsAmplitudeAndUsesIt) {
  float lowest = 0, highest = 0;
  const auto values = noise(200);
  for (const float value : values[2]) {
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
  }
  EXPECT_GE(lowest, -1);
  EXPECT_LE(highest, 1);
  EXPECT_GT(highest - lowest, 1.5) << "a thousand cubes come near both ends";
}

TEST(Noise, HasNoMean) {
  double sum = 0;
  const auto values = noise(200);
  for (const float value : values[0]) sum += value;
  // About 200 x 2 pi independent cubes of variance below 1/3: four standard errors of their mean.
  EXPECT_WITHIN(sum / count, 0, 4 * std::sqrt(1.0 / 3 / 1257), "four standard errors");
}

TEST(Noise, IsContinuous) {
  const auto values = noise(50)[1];
  const double step = 50 * 6.2831853 / count;
  for (std::size_t i = 0; i < count; ++i)
    EXPECT_WITHIN(values[i], values[(i + 1) % count], 2 * 1.5 * 1.8 * step + 1e-4,
                  "values differ by at most 2, the smooth step's slope is 1.5, along a diagonal");
}

TEST(Noise, ItsFourValuesDiffer) {
  double product = 0, square = 0;
  const auto values = noise(200);
  for (std::size_t i = 0; i < count; ++i) {
    product += values[0][i] * values[3][i];
    square += values[0][i] * values[0][i];
  }
  EXPECT_WITHIN(product / square, 0, 0.15, "four standard errors of 1257 independent cubes");
}

TEST(Noise, AddsToWhatIsThere) {
  const auto sums = noise(20, {0.5F, 0, 0, 0}, 5), alone = noise(20);
  for (std::size_t i = 0; i < count; i += 997) {
    EXPECT_WITHIN(sums[0][i], 5 + 0.5 * alone[0][i], 1e-6, "floats' rounding");
    EXPECT_EQ(sums[1][i], 5);
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
