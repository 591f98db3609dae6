// SPDX-License-Identifier: MIT
#include "colour/difference.h"

#include "baker/atmosphere/published_table.h"
#include "support/testing.h"

namespace coppermoon::colour::difference_test {

struct Pair {
  Lab one, other;
  double delta_e;
};

std::vector<Pair> published_pairs() {
  const auto t = published_table("colour/data/ciede2000_pairs.csv");
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < t["L1"].size(); ++i)
    pairs.push_back({{t["L1"][i], t["a1"][i], t["b1"][i]},
                     {t["L2"][i], t["a2"][i], t["b2"][i]},
                     t["delta_e"][i]});
  return pairs;
}

void expect_lab(const Lab& lab, const std::array<double, 3>& reference, double tolerance,
                const char* reason) {
  EXPECT_WITHIN(lab.L, reference[0], tolerance, reason);
  EXPECT_WITHIN(lab.a, reference[1], tolerance, reason);
  EXPECT_WITHIN(lab.b, reference[2], tolerance, reason);
}

TEST(ColourDifference, IsThatOfThePublishedPairs) {
  const auto pairs = published_pairs();
  ASSERT_EQ(pairs.size(), 34U);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    SCOPED_TRACE(i + 1);
    EXPECT_WITHIN(delta_e_2000(pairs[i].one, pairs[i].other), pairs[i].delta_e, 1e-4,
                  "printed to 4 decimals");
  }
}

TEST(ColourDifference, IsTheSameWhicheverComesFirst) {
  for (const auto& pair : published_pairs())
    EXPECT_WITHIN(delta_e_2000(pair.one, pair.other), delta_e_2000(pair.other, pair.one), 1e-12,
                  "rounding");
}

TEST(ColourDifference, OfEqualColoursIsNothing) {
  for (const auto& pair : published_pairs()) EXPECT_EQ(delta_e_2000(pair.one, pair.one), 0);
  EXPECT_EQ(delta_e_2000({0, 0, 0}, {0, 0, 0}), 0);
}

TEST(ColourDifference, OfBlackAndWhiteIsAHundred) {
  // S_L = 1 at the mean lightness of 50, and nothing but lightness differs.
  EXPECT_WITHIN(delta_e_2000({0, 0, 0}, {100, 0, 0}), 100.0, 1e-12, "rounding");
}

TEST(Lab, OfTheSrgbPrimariesAsPublished) {
  const char* reason = "published to 2 decimals, of matrices printed to 4";
  expect_lab(lab_from_srgb({1, 1, 1}), {100, 0, 0}, 0.01, reason);
  expect_lab(lab_from_srgb({1, 0, 0}), {53.24, 80.09, 67.20}, 0.015, reason);
  expect_lab(lab_from_srgb({0, 1, 0}), {87.73, -86.18, 83.18}, 0.015, reason);
  expect_lab(lab_from_srgb({0, 0, 1}), {32.30, 79.19, -107.86}, 0.015, reason);
}

TEST(Lab, OfTheDarkIsProportionalToTheLight) {
  // Below Y = 216/24389, L* = (29/3)³ Y; below the code 0.04045, Y is the code over 12.92.
  const double slope = std::pow(29. / 3, 3);
  EXPECT_WITHIN(lab_from_xyz({0, 0.001, 0}).L, slope * 0.001, 1e-12, "rounding");
  EXPECT_WITHIN(lab_from_srgb({0.04F, 0.04F, 0.04F}).L, slope * 0.04 / 12.92, 1e-6,
                "0.04 is rounded to a float");
}

TEST(Lab, RefusesWhatNoPictureHolds) {
  EXPECT_THROW(lab_from_srgb({-0.01F, 0, 0}), algebra::Error);
  EXPECT_THROW(lab_from_srgb({0, 1.01F, 0}), algebra::Error);
  EXPECT_THROW(lab_from_srgb({0, 0, std::numeric_limits<float>::quiet_NaN()}), algebra::Error);
}

}  // namespace coppermoon::colour::difference_test
