// SPDX-License-Identifier: MIT
#include "uses/night/visibility_map.h"

#include "support/testing.h"

namespace coppermoon::uses::visibility_map_test {

TEST(VisibilityMap, TheMoonIsInTheHorizonAllAlongTheCircle) {
  const auto when = almanac::instant_from_utc("2018-07-27T20:21:45Z");
  const auto sky = almanac::sky_at(when);
  for (const auto& [latitude, longitude] : horizon_circle(when, 25)) {
    const auto view =
        almanac::view_from({algebra::degrees(latitude), algebra::degrees(longitude), {}}, sky);
    const double limb_deg = algebra::in_degrees(view.altitude) + 34. / 60 +
                            std::asin(almanac::lunar_radius / view.moon_distance) * 57.29578;
    EXPECT_WITHIN(limb_deg, 0, 0.2, "degrees: the ellipsoid's vertical, 11.5'");
  }
}

TEST(VisibilityMap, IsDrawnByGnuplotWithTimesToTheMinute) {
  const auto eclipse = *eclipse::eclipse_of_day(almanac::instant_from_utc("2018-07-27"),
                                                eclipse::ShadowConvention::danjon);
  EXPECT_THROW(write_visibility_map("a.jpg", eclipse), algebra::Error);
  const auto file = std::filesystem::temp_directory_path() / "coppermoon_map_test.svg";
  write_visibility_map(file, eclipse);
  EXPECT_GT(std::filesystem::file_size(file), 50000U) << "coastlines alone are 5000 points";
  std::ifstream in(file);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  EXPECT_SAYS(text, "greatest 20:22") << "20:21:45, rounded";
  std::filesystem::remove(file);
}

}  // namespace coppermoon::uses::visibility_map_test
