// SPDX-License-Identifier: MIT
// Moon and stars that are part of the library, against the data of Stellarium's that they were made from.
#include <cstdlib>

#include "support/testing.h"
#include "surface/albedo_map.h"
#include "uses/picture/moon.h"

namespace coppermoon::uses::moon_and_stars_test {

/// Stored albedo over that of Stellarium's map, less 1.
struct Stored {
  double rms = 0, most = 0;
};

Stored stored_within(double latitude_deg) {
  MoonRequest theirs{.albedo_map = "/usr/share/stellarium/textures/moon_4k.jpg",
                     .albedo_encoding = AlbedoEncoding::cgi_moon_kit_2019};
  const auto expected = normal_albedo(theirs), found = normal_albedo({});
  Stored stored;
  double squares = 0, area = 0;
  for (std::size_t r = 0; r < found.rows(); ++r) {
    const auto latitude = surface::texel_centre(r, 0, found.rows()).latitude;
    if (std::abs(algebra::in_degrees(latitude)) > latitude_deg) continue;
    for (std::size_t c = 0; c < found.columns(); ++c) {
      const double error = double{found(r, c)} / double{expected(r, c)} - 1;
      stored.most = std::max(stored.most, std::abs(error));
      squares += error * error * std::cos(algebra::in_radians(latitude));
      area += std::cos(algebra::in_radians(latitude));
    }
  }
  stored.rms = std::sqrt(squares / area);
  return stored;
}

TEST(BuiltInMap, IsStoredAsExactlyAsItSays) {
  const char* reason = "surface/built_in_map.h";
  EXPECT_WITHIN(stored_within(90).rms, 0, 0.0023, reason);
  EXPECT_WITHIN(stored_within(90).most, 0, 0.11, reason);
  EXPECT_WITHIN(stored_within(64).rms, 0, 0.0014, reason);
  EXPECT_WITHIN(stored_within(64).most, 0, 0.013, reason);
}

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator(file), {}};
}

TEST(Stars, AreMadeAgainFromStellariumsCatalogues) {
  const std::filesystem::path data = COPPERMOON_TEST_DATA "/../baker/almanac/data";
  const auto made = testing::TempDir() + "stars_made_again.bin";
  const auto command = "python3 '" + (data / "make_stars.py").string() +
                       "' /usr/share/stellarium/stars/default '" + made + "'";
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(bytes_of(made), bytes_of(data / "stars.bin"));
  std::filesystem::remove(made);
}

}  // namespace coppermoon::uses::moon_and_stars_test
