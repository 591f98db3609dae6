// SPDX-License-Identifier: MIT
#include "uses/picture/caption.h"

#include "support/testing.h"

namespace coppermoon::uses::caption_test {

using almanac::Observer;

Observer at(double latitude_deg, double longitude_deg) {
  return {algebra::degrees(latitude_deg), algebra::degrees(longitude_deg), {}};
}

texture::Attributes header(const char* date, float latitude, float longitude) {
  return {{"capDate", std::string(date)}, {"latitude", latitude}, {"longitude", longitude}};
}

TEST(Caption, HasTheLocalTimeThePlaceAndTheContact) {
  // greatest 20:21:45 UTC; U2 19:30:15 (NASA's catalogue); East Africa is three hours ahead
  const auto greatest = caption_of(header("2018:07:27 20:21:45", -1.28F, 36.82F));
  EXPECT_EQ(greatest.left, "2018-07-27 23:21:45 EAT, Nairobi");
  EXPECT_EQ(greatest.right, "greatest");
  const auto after = caption_of(header("2018:07:27 19:42:15", -1.28F, 36.82F));
  EXPECT_EQ(after.right, "U2+12min");
  EXPECT_EQ(caption_of({{"capDate", std::string("2018:07:27 20:21:45")}}).left,
            "2018-07-27 20:21:45 UTC")
      << "from the Earth's centre";
  EXPECT_EQ(caption_of(header("2018:07:20 20:21:45", -1.28F, 36.82F)).right, "") << "no eclipse";
}

TEST(Caption, NeedsAMoment) { EXPECT_THROW(caption_of({}), algebra::Error); }

TEST(PlaceInWords, IsACityNearbyElseDegrees) {
  EXPECT_EQ(place_in_words(at(34.05, -118.24)), "Los Angeles");
  EXPECT_EQ(place_in_words(at(34.05, 241.77)), "Los Angeles") << "east of Greenwich";
  EXPECT_EQ(place_in_words(at(-30, 80)), "30.00° S, 80.00° E");
}

}  // namespace coppermoon::uses::caption_test
