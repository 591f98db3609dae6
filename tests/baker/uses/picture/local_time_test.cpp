// SPDX-License-Identifier: MIT
#include "uses/picture/local_time.h"

#include <cstdlib>

#include "support/testing.h"
#include "uses/picture/caption.h"

namespace coppermoon::uses::local_time_test {

almanac::Observer at(double latitude_deg, double longitude_deg) {
  return {algebra::degrees(latitude_deg), algebra::degrees(longitude_deg), {}};
}

TEST(TimeZoneOf, IsThatOfACityNearbyElseOfTheLongitude) {
  EXPECT_EQ(time_zone_of(at(21.5, -158)), "Pacific/Honolulu");
  EXPECT_EQ(whose_clocks(at(21.5, -158)),
            "Local times are those of Honolulu (Pacific/Honolulu), the nearest city that is known, "
            "26 km away.");
  // Kiritimati, Chatham and Attu, and the middle of the Atlantic
  for (const auto& [place, zone] : {std::pair{at(1.87, -157.4), "Etc/GMT+10"},
                                    {at(-43.95, -176.55), "Etc/GMT+12"},
                                    {at(52.9, 172.9), "Etc/GMT-12"},
                                    {at(52.9, -187.1), "Etc/GMT-12"},
                                    {at(0, -3), "Etc/GMT+0"}}) {
    EXPECT_EQ(time_zone_of(place), zone);
    EXPECT_NO_THROW(local_time({2451545, 0}, zone)) << zone;
  }
  EXPECT_EQ(whose_clocks(at(1.87, -157.4)),
            "Local times are by the longitude, UTC-10: the nearest city that is known, Hilo, is "
            "2002 km away.");
}

TEST(ZoneOrUtc, IsUtcWhereTheSystemLacksTheZone) {
  EXPECT_EQ(zone_or_utc(at(-1.28, 36.82)), "Africa/Nairobi");
  ::setenv("TZDIR", "/nonexistent", 1);
  EXPECT_EQ(zone_or_utc(at(39.9, 32.86)), "+00:00") << "Ankara's, which nothing has read yet";
  const auto caption = caption_of({{"capDate", std::string("2018:07:27 20:21:45")},
                                   {"latitude", 39.9F},
                                   {"longitude", 32.86F}});
  ::unsetenv("TZDIR");
  EXPECT_TRUE(caption.left.starts_with("2018-07-27 20:21:45 UTC, ")) << caption.left;
}

}  // namespace coppermoon::uses::local_time_test
