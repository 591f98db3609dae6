// SPDX-License-Identifier: MIT
#include "uses/fit/measured_light.h"

#include "support/csv_rows.h"
#include "support/testing.h"

namespace coppermoon::uses::measured_light_test {

TEST(MeasuredLight, OfEachNightIsARowOfTheTable) {
  const std::vector<std::vector<MeasuredLight>> nights{
      {{.distance_km = 1000, .channel = 0, .light = 2e-5, .model = 3e-5, .error = 0.1},
       {.distance_km = 1500, .channel = 2, .light = 4e-6, .model = 5e-6, .error = 0.2}},
      {{.distance_km = 2000, .channel = 1, .light = 6e-5, .model = 7e-5, .error = 0.3}}};
  const auto file = std::filesystem::path(testing::TempDir()) / "measured_light.csv";
  write_measured_light(file, nights);
  std::ifstream in(file);
  const auto rows = csv_rows({std::istreambuf_iterator<char>(in), {}});
  std::filesystem::remove(file);
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[1].at("night") + rows[1].at("channel"), "1B");
  EXPECT_EQ(rows[2].at("night") + rows[2].at("channel"), "2G");
  EXPECT_WITHIN_RELATIVE(std::stod(rows[1].at("light")), 4e-6, 1e-5, "six digits");
  EXPECT_WITHIN_RELATIVE(std::stod(rows[1].at("model")), 5e-6, 1e-5, "six digits");
  EXPECT_WITHIN_RELATIVE(std::stod(rows[1].at("error")), 0.2, 1e-2, "three digits");
}

}  // namespace coppermoon::uses::measured_light_test
