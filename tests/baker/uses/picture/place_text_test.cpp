// SPDX-License-Identifier: MIT
#include "uses/picture/place_text.h"
#include "support/testing.h"

namespace coppermoon::uses::place_text_test {

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

TEST(ObserverFrom, ReadsLettersOfTheCompass) {
  const auto place = observer_from("41.88N,87.63W,180");
  EXPECT_WITHIN(in_degrees(place.latitude), 41.88, 1e-12, reason);
  EXPECT_WITHIN(in_degrees(place.longitude), -87.63, 1e-12, reason);
  EXPECT_EQ(in_metres(place.elevation), 180);
  EXPECT_WITHIN(in_degrees(observer_from("33.9S,18.4E").latitude), -33.9, 1e-12, reason);
  for (const char* text : {"41.88W,87.63N", "41.88N", "-41.88S,1", "N,W", "41.88n,87w"})
    EXPECT_THROW(observer_from(text), algebra::Error) << text;
}

TEST(ObserverFrom, ReadsPlacesAsMapsCopyThem) {
  const auto expect = [](const char* text, double north, double east, double elevation_m = 0) {
    const auto place = observer_from(text);
    EXPECT_WITHIN(in_degrees(place.latitude), north, 1e-9, reason) << text;
    EXPECT_WITHIN(in_degrees(place.longitude), east, 1e-9, reason) << text;
    EXPECT_EQ(in_metres(place.elevation), elevation_m) << text;
  };
  expect("51.5, -0.12", 51.5, -0.12);
  expect(" 51.5 , -0.12, 30 ", 51.5, -0.12, 30);
  expect("21°18'N, 157°52'W", 21.3, -157 - 52. / 60);
  expect("21°18'25.2\"N 157°51'30\"W", 21 + 18. / 60 + 25.2 / 3600, -157 - 51.5 / 60);
  expect("51°30′26″N 0°7′39″W", 51 + 30. / 60 + 26. / 3600, -7. / 60 - 39. / 3600);
  expect("51.5° N, 0.12° W", 51.5, -0.12);
  expect("-33°54', 18°24'", -33.9, 18.4);
  expect("33.9S 18.4E", -33.9, 18.4);
  for (const char* text : {"21°18'N", "21°60'N, 157°W", "-21°18'S, 157°W", "21°18N, 157°W",
                           "21°18'12\"5N, 1W", "°N, 1W", "157°W, 21°N", "21°-18'N, 1W"})
    EXPECT_THROW(observer_from(text), algebra::Error) << text;
}

TEST(ObserverFrom, KnowsCitiesWithDigitsAndWithCountries) {
  EXPECT_WITHIN(in_degrees(observer_from("Sector 3").latitude), 44.42, 1e-9, reason);
  EXPECT_WITHIN(in_degrees(observer_from("Berlin, Germany").latitude), 52.52, 1e-9, reason);
  EXPECT_WITHIN(in_degrees(observer_from("Washington, D.C.").longitude), -77.04, 1e-9, reason);
  EXPECT_THROW(observer_from("3"), algebra::Error);
}

std::string refusal(const char* place) {
  return refusal_of([&] { observer_from(place); });
}

TEST(ObserverFrom, KnowsCitiesByName) {
  EXPECT_EQ(in_metres(observer_from("Chicago").elevation), 180);
  for (const auto& [text, said] : {std::pair{"Chigaco", "nearest name is Chicago"},
                                   {"Münchn", "nearest name is Munich"},
                                   {"Lisbonne", "nearest name is Lisbon"},
                                   {"Paris, Texas", "Paris is known in Ile-de-France."}})
    EXPECT_SAYS(refusal(text), said) << refusal(text);
}

TEST(FeatureFrom, KnowsCratersByName) {
  EXPECT_WITHIN(in_degrees(feature_from("Tycho").latitude), -43.3, 0.1,
                "degrees: as it is rounded");
  EXPECT_WITHIN(in_degrees(feature_from("-43.3,-11.4").longitude), -11.4, 1e-12, reason);
  for (const char* text : {"", "Tyco Brahe", "-91,0", "1,2,3"})
    EXPECT_THROW(feature_from(text), algebra::Error) << text;
}

TEST(ObserverFrom, RefusesWhatIsNoPlace) {
  for (const char* text :
       {"", "42", "42,", "42,x", "1,2,3,4", "91,0", "-90.1,0", "0,361", "nan,0", "42 -73"})
    EXPECT_THROW(observer_from(text), algebra::Error) << text;
}

}  // namespace coppermoon::uses::place_text_test
