// SPDX-License-Identifier: MIT
#include "almanac/observer.h"

#include <glm/geometric.hpp>

#include "baker/almanac/published_rows.h"
#include "support/testing.h"

namespace coppermoon::almanac::observer_test {

using algebra::degrees;
using algebra::in_degrees;
using algebra::metres;

const Observer clifton_park{degrees(42.86), degrees(-73.77), metres(0)};

SkyState some_sky() {
  return sky_at(instant_from_utc("2008-02-21T03:26:05Z"), LunarTheory::moon98);
}

TEST(Observer, AltitudeAndAzimuthAgreeWithDe431) {
  const char* reason = "the goal is 0.02°; table to 0.0001°, its ΔT up to 0.3 s off: 0.00005°";
  for (const auto& row : published_rows("baker/almanac/data/moon_places.csv")) {
    const SkyState sky = sky_at(instant_from_utc(row.at("utc")));
    const ObserverView view = view_from(clifton_park, sky);
    EXPECT_WITHIN(in_degrees(view.altitude), number(row, "altitude_deg"), 0.001, reason);
    EXPECT_WITHIN(in_degrees(view.azimuth), number(row, "azimuth_deg"), 0.001, reason);
  }
}

TEST(Observer, StandsOnTheEllipsoid) {
  const SkyState sky = some_sky();
  const Observer pole{degrees(90), degrees(0), metres(0)},
      equator{degrees(0), degrees(30), metres(0)};
  EXPECT_WITHIN(glm::length(view_from(pole, sky).position_m), 6356752.314, 0.01,
                "WGS 84 defines it");
  EXPECT_WITHIN(glm::length(view_from(equator, sky).position_m), 6378137.0, 0.01, "the same");
}

TEST(Observer, FromTheNorthPoleTheAltitudeIsTheDeclinationLessParallax) {
  const SkyState sky = some_sky();
  const ObserverView view = view_from({degrees(90), degrees(0), metres(0)}, sky);
  const auto place = equatorial_place(sky, sky.moon_m);
  const double distance_m = algebra::in_metres(place.distance),
               declination = algebra::in_radians(place.declination);
  const double expected = std::atan2(distance_m * std::sin(declination) - 6356752.314,
                                     distance_m * std::cos(declination));
  EXPECT_WITHIN(algebra::in_radians(view.altitude), expected, 1e-9, "closed form, rounding");
}

TEST(Observer, TheParallacticAngleIsNegativeEastOfTheMeridian) {
  const SkyState sky = some_sky();
  const ObserverView rising = view_from(clifton_park, sky);
  ASSERT_LT(in_degrees(rising.azimuth), 180);
  EXPECT_LT(in_degrees(rising.parallactic_angle), 0);
  const double sine =
      -std::sin(algebra::in_radians(rising.azimuth)) *
      std::cos(algebra::in_radians(clifton_park.latitude)) /
      std::cos(std::asin(glm::dot(glm::normalize(sky.moon_m - rising.position_m), rising.north)));
  EXPECT_WITHIN(std::sin(algebra::in_radians(rising.parallactic_angle)), sine, 1e-9,
                "sine rule of the triangle pole, zenith, Moon; rounding");
}

TEST(Observer, ParallaxMovesTheCentreOfTheDiscByUnderADegree) {
  const SkyState sky = some_sky();
  const ObserverView view = view_from(clifton_park, sky);
  const double moved_deg =
      std::hypot(in_degrees(view.sub_observer.latitude - sky.sub_earth.latitude),
                 in_degrees(view.sub_observer.longitude - sky.sub_earth.longitude));
  const double parallax_deg =
      in_degrees(algebra::radians(std::asin(6378137 / glm::length(sky.moon_m)))) *
      std::cos(algebra::in_radians(view.altitude));
  EXPECT_WITHIN(moved_deg, parallax_deg, 0.02,
                "π cos h: the libration moves by the parallax, to its square");
}

TEST(Observer, PlacesOffTheEarthAreRefused) {
  const SkyState sky = some_sky();
  EXPECT_THROW(view_from({degrees(90.1), degrees(0), metres(0)}, sky), algebra::Error);
  EXPECT_THROW(view_from({degrees(0), degrees(-361), metres(0)}, sky), algebra::Error);
  EXPECT_THROW(view_from({degrees(0), degrees(0), metres(-501)}, sky), algebra::Error);
  EXPECT_THROW(view_from({degrees(0), degrees(0), metres(1.1e5)}, sky), algebra::Error);
}

}  // namespace coppermoon::almanac::observer_test
