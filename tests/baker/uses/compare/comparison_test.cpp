// SPDX-License-Identifier: MIT
#include "uses/compare/comparison.h"

#include "support/testing.h"

namespace coppermoon::uses {
namespace {

/// Pixels of 1 cd/m² at two distances; of those farther out some are black in the photograph.
std::vector<SharedPixel> pixels(std::size_t black) {
  std::vector<SharedPixel> all;
  for (std::size_t i = 0; i < 10; ++i) {
    all.push_back({1000, glm::dvec3(0.5), glm::dvec3(1), false});
    all.push_back({2000, glm::dvec3(i < black ? 0 : 0.5), glm::dvec3(1), false});
  }
  return all;
}

TEST(Differences, SayNothingWhereMostOfThePhotographIsBlack) {
  const auto most = differences(pixels(6), 0.5, 2);
  EXPECT_EQ(most[0].stops, 0.);
  EXPECT_EQ(most[1].black, 6);
  EXPECT_FALSE(most[1].stops || most[1].photo_uv || most[1].render_uv || most[1].delta_e_2000);
  const auto half = differences(pixels(5), 0.5, 2);
  EXPECT_EQ(half[1].stops, -1.);
}

}  // namespace
}  // namespace coppermoon::uses
