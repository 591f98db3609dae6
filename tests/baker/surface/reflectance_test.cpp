// SPDX-License-Identifier: MIT
#include "surface/reflectance.h"

#include "algebra/table.h"
#include "support/testing.h"

namespace reflectance_test {

using coppermoon::algebra::nanometres;
using coppermoon::surface::lunar_reflectance_yapo_cutler;

coppermoon::algebra::Table soil() {
  std::ifstream file(COPPERMOON_TEST_DATA "/baker/surface/data/apollo16_62231.csv");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  return coppermoon::algebra::parse_table(text, "62231");
}

TEST(LunarReflectance, FollowsTheSoilOfApollo16) {
  const auto table = soil();
  const auto& wavelength = table["wavelength_nm"];
  const auto& reflectance = table["reflectance"];
  ASSERT_EQ(wavelength.size(), 81) << "the paper's 81 points from 380 to 780 nm";
  double worst = 0, squares = 0;
  for (std::size_t i = 0; i < wavelength.size(); ++i) {
    const double measured = reflectance[i] / reflectance.back();
    const double off = lunar_reflectance_yapo_cutler(nanometres(wavelength[i])) / measured - 1;
    worst = std::max(worst, std::abs(off));
    squares += off * off;
  }
  EXPECT_WITHIN(worst, 0, 0.0042, "the docstring's worst; the measurement itself is good to 3 %");
  EXPECT_WITHIN(std::sqrt(squares / 81), 0, 0.0021, "the docstring's RMS");
}

TEST(LunarReflectance, ComesCloserWhenNotBoundToOneAt780) {
  const auto table = soil();
  double lowest = 1e9, highest = 0;
  for (std::size_t i = 0; i < 81; ++i) {
    const double ratio = lunar_reflectance_yapo_cutler(nanometres(table["wavelength_nm"][i])) /
                         table["reflectance"][i];
    lowest = std::min(lowest, ratio);
    highest = std::max(highest, ratio);
  }
  EXPECT_WITHIN(highest / lowest, 1, 2 * 0.003, "the paper's 0.3 % either way");
}

TEST(LunarReflectance, IsOneAt780) {
  EXPECT_WITHIN(lunar_reflectance_yapo_cutler(nanometres(780)), 1, 5e-5,
                "coefficients of five digits");
}

TEST(LunarReflectance, HasARange) {
  EXPECT_THROW(lunar_reflectance_yapo_cutler(nanometres(379.9)), coppermoon::algebra::Error);
  EXPECT_THROW(lunar_reflectance_yapo_cutler(nanometres(780.1)), coppermoon::algebra::Error);
  EXPECT_THROW(lunar_reflectance_yapo_cutler(nanometres(NAN)), coppermoon::algebra::Error);
}

}  // namespace reflectance_test
