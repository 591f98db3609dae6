// SPDX-License-Identifier: MIT
#include "verbs/observer_options.h"

#include "algebra/error.h"
#include "almanac/instant.h"
#include "support/within.h"

namespace coppermoon::verbs {
namespace {

constexpr const char* reason = "rounding between degrees and radians";

TEST(ObserverFrom, ReadsLatitudeLongitudeAndElevation) {
  const auto place = observer_from("42.86,-73.77,120");
  EXPECT_WITHIN(in_degrees(place.latitude), 42.86, 1e-12, reason);
  EXPECT_WITHIN(in_degrees(place.longitude), -73.77, 1e-12, reason);
  EXPECT_WITHIN(in_metres(place.elevation), 120, 1e-12, reason);
}

TEST(ObserverFrom, StandsAtSeaLevelUnlessToldOtherwise) {
  EXPECT_EQ(in_metres(observer_from("-33.9,18.4").elevation), 0);
}

TEST(ObserverFrom, RefusesWhatIsNoPlace) {
  for (const char* text :
       {"", "42", "42,", "42,x", "1,2,3,4", "91,0", "-90.1,0", "0,361", "nan,0", "42 -73"})
    EXPECT_THROW(observer_from(text), algebra::Error) << text;
}

almanac::SkyState mid_eclipse() {
  return almanac::sky_at(almanac::instant_from_utc("2008-02-21T03:26:05Z"));
}

ViewOptions from(const char* place) {
  ViewOptions options;
  options.at = place;
  return options;
}

TEST(ViewOf, ReddensTheMoonOnlyThroughAir) {
  const auto sky = mid_eclipse();
  auto options = from("42.86,-73.77");
  EXPECT_FALSE(view_of({}, sky).reddening_altitude);
  EXPECT_TRUE(view_of(options, sky).reddening_altitude);
  options.reddening = "off";
  EXPECT_FALSE(view_of(options, sky).reddening_altitude);
}

TEST(ViewOf, TakesTheFieldFromLensAndSensorUnlessTold) {
  const auto sky = mid_eclipse();
  const double paper_deg = 2 * std::atan(22.7 / 1540 / 2) * 180 / std::numbers::pi;
  EXPECT_WITHIN(in_degrees(view_of({}, sky).camera.horizontal_field), paper_deg, 1e-12, reason);
  ViewOptions told;
  told.field_deg = 2;
  EXPECT_WITHIN(in_degrees(view_of(told, sky).camera.horizontal_field), 2, 1e-12, reason);
}

TEST(ViewOf, SaysHowFarBelowTheHorizonTheMoonIs) {
  try {
    view_of(from("-30,150"), mid_eclipse());
    FAIL() << "the Moon of one in the afternoon was seen";
  } catch (const algebra::Error& error) {
    EXPECT_NE(std::string(error.what()).find("degrees below the horizon of -30,150"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace coppermoon::verbs
