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

constexpr const char *low_moon = "42,47.3", *just_set = "42,50.3", *set = "42,51";

ViewOptions from(const char* place) {
  ViewOptions options;
  options.at = place;
  return options;
}

TEST(ViewOf, ReddensTheMoonOnlyThroughAir) {
  const auto sky = mid_eclipse();
  auto options = from("42.86,-73.77");
  EXPECT_FALSE(view_of({}, sky).sightline);
  EXPECT_TRUE(view_of(options, sky).sightline);
  options.reddening = "off";
  EXPECT_FALSE(view_of(options, sky).sightline);
}

TEST(ViewOf, LooksThroughTheAirItIsTold) {
  auto options = from("42.86,-73.77,120");
  options.observer_ozone_du = 250;
  options.observer_aerosol = 0.05;
  const auto air = view_of(options, mid_eclipse()).sightline->air;
  EXPECT_EQ(air.ozone_du, 250);
  EXPECT_EQ(air.aerosol_optical_depth, 0.05);
  EXPECT_EQ(air.elevation_m, 120);
  options.observer_aerosol = -1;
  EXPECT_THROW(view_of(options, mid_eclipse()), algebra::Error);
}

TEST(ViewOf, FlattensTheMoonOnlyThroughAir) {
  const auto sky = mid_eclipse();
  auto options = from(low_moon);
  EXPECT_EQ(view_of({}, sky).camera.flattening, 1);
  const double flattening = view_of(options, sky).camera.flattening;
  EXPECT_WITHIN(flattening, 0.93, 0.05, "0.9 at 1 degree, 0.955 at 3");
  options.reddening = "off";
  EXPECT_EQ(view_of(options, sky).camera.flattening, flattening);
  options.flattening = "off";
  EXPECT_EQ(view_of(options, sky).camera.flattening, 1);
}

TEST(ViewOf, ShowsAMoonThatOnlyRefractionLiftsOverTheHorizon) {
  const auto sky = mid_eclipse();
  const auto view = view_of(from(just_set), sky);
  const double altitude_deg = in_degrees(view.sightline->altitude);
  EXPECT_TRUE(altitude_deg < -0.1 && altitude_deg > -0.5) << altitude_deg;
  EXPECT_THROW(view_of(from(set), sky), algebra::Error);
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
