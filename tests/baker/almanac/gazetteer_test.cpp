// SPDX-License-Identifier: MIT
#include "almanac/gazetteer.h"

#include <cmath>
#include <filesystem>
#include <set>

#include "support/within.h"

namespace coppermoon::almanac {
namespace {

double latitude(const Observer& place) { return in_degrees(place.latitude); }
double longitude(const Observer& place) { return in_degrees(place.longitude); }

TEST(Gazetteer, CitiesAreWhereTheirObservatoriesAre) {
  // The Astronomical Almanac, section J, of observatories within the city; to 0.2 degrees, a large
  // city's size
  struct Published {
    const char* name;
    double latitude, longitude;
  };
  for (const auto& [name, north, east] :
       {Published{"Edinburgh", 55.92, -3.18}, Published{"Cape Town", -33.93, 18.48},
        Published{"Vienna", 48.23, 16.34}, Published{"Chicago", 41.83, -87.62},
        Published{"Tokyo", 35.67, 139.54}, Published{"Sydney", -33.86, 151.21}}) {
    const auto city = city_named(name);
    ASSERT_TRUE(city) << name;
    EXPECT_WITHIN(latitude(city->place), north, 0.2, "degrees: a large city's size");
    EXPECT_WITHIN(longitude(city->place), east, 0.2, "degrees: a large city's size");
  }
}

TEST(Gazetteer, NamesAreFoundWhateverTheirCaseAndAccents) {
  for (const char* name : {"sao paulo", "SÃO PAULO", "São Paulo"})
    EXPECT_EQ(city_named(name)->time_zone, "America/Sao_Paulo") << name;
  EXPECT_EQ(city_named("New York")->name, "New York City");
  EXPECT_FALSE(city_named("York New"));
  EXPECT_FALSE(city_named(""));
  EXPECT_FALSE(city_named("/Illinois"));
  EXPECT_EQ(plain_name("Šafařík"), "safarik");
  EXPECT_EQ(plain_name("\xC5"), "\xC5");  // cut short: left as it is
}

TEST(Gazetteer, TheMostPopulousOfANameIsMeantUnlessItsRegionIsSaid) {
  EXPECT_LT(longitude(city_named("London/Ontario")->place), -80);
  EXPECT_GT(longitude(city_named("London")->place), -1);
  EXPECT_EQ(city_named("Springfield/Illinois")->region, "Illinois");
  EXPECT_FALSE(city_named("Chicago/Texas"));
}

TEST(Gazetteer, CitiesAreFoundByOtherNamesAndUmlautsThatAreSpelt) {
  for (const auto& [name, english] : {std::pair{"München", "Munich"},
                                      {"Mu\u0308nchen", "Munich"},
                                      {"MUENCHEN", "Munich"},
                                      {"Köln", "Koeln"},
                                      {"Nürnberg", "Nuernberg"},
                                      {"Göteborg", "Goeteborg"},
                                      {"wien", "Vienna"},
                                      {"București", "Bucharest"},
                                      {"Geneva", "Geneve"}}) {
    const auto city = city_named(name);
    ASSERT_TRUE(city) << name;
    EXPECT_EQ(city->name, english);
  }
  EXPECT_EQ(city_taken("München"), "");
}

TEST(Gazetteer, WhichCityIsTakenIsSaidWhereThereIsADoubt) {
  EXPECT_EQ(city_taken("Springfield"),
            "Springfield is Springfield/Missouri; others are Springfield/Massachusetts, "
            "Springfield/Illinois");
  EXPECT_EQ(city_taken("New York"),
            "New York is New York City/New York; others are East New York/New York");
  EXPECT_TRUE(city_taken("san").ends_with(" more")) << "not all of hundreds";
  for (const char* name : {"Springfield, Illinois", "Springfield/Illinois", "Nairobi", "Nowhere",
                           "London"})  // Ontario's has a twentieth of the people
    EXPECT_EQ(city_taken(name), "") << name;
}

TEST(Gazetteer, ARegionMayStandBehindAComma) {
  EXPECT_EQ(city_named("Springfield, illinois")->region, "Illinois");
  EXPECT_FALSE(city_named("Paris, France"));
  EXPECT_FALSE(city_named(", Illinois"));
  EXPECT_EQ(no_such_city("Paris, France"), "no such city; Paris is known in Ile-de-France");
  EXPECT_EQ(no_such_city("Springfield, IL"),
            "no such city; Springfield is known in Missouri, Massachusetts, Illinois");
  EXPECT_EQ(no_such_city("Atlantis"), "no such city");
}

TEST(Gazetteer, TimeZonesAreThoseOfTheSystem) {
  std::set<std::string> zones;
  const auto names = city_names();
  for (std::size_t i = 0; i < names.size(); i += 20) zones.insert(city_named(names[i])->time_zone);
  EXPECT_GT(zones.size(), 80U);
  for (const auto& zone : zones)
    EXPECT_TRUE(std::filesystem::exists("/usr/share/zoneinfo/" + zone)) << zone;
}

TEST(Gazetteer, TheNearestCityIsFoundAcrossTheDateLine) {
  const auto at = [](double north, double east) {
    return nearest_city({algebra::degrees(north), algebra::degrees(east), {}}).name;
  };
  EXPECT_EQ(at(41.9, -87.6), "Chicago");
  EXPECT_EQ(at(-18.2, -179.9), "Suva");  // of Fiji, at 178.4 east: 1.7 degrees away
}

TEST(LunarFeatures, AreWhereTheIauHasThem) {
  struct Published {
    const char* name;
    double latitude, longitude, diameter_km;
  };
  for (const auto& [name, north, east, km] :
       {Published{"Tycho", -43.31, -11.36, 85}, Published{"Copernicus", 9.62, -20.08, 93},
        Published{"Plato", 51.62, -9.38, 101}, Published{"Mare Crisium", 17.0, 59.1, 556},
        Published{"Grimaldi", -5.38, -68.36, 172}}) {
    const auto feature = lunar_feature_named(name);
    ASSERT_TRUE(feature) << name;
    EXPECT_WITHIN(in_degrees(feature->middle.latitude), north, 1, "degrees: a mare has no centre");
    EXPECT_WITHIN(in_degrees(feature->middle.longitude), east, 0.2, "degrees");
    EXPECT_WITHIN(in_kilometres(feature->diameter), km, 4, "km: a rim is no circle");
  }
  EXPECT_EQ(lunar_feature_named("crisium")->name, "Mare Crisium");
  EXPECT_EQ(lunar_feature_named("linne")->name, "Linné");
  EXPECT_FALSE(lunar_feature_named("Atlantis"));
}

TEST(LunarFeatures, LieOnTheMoon) {
  const auto names = lunar_feature_names();
  ASSERT_GT(names.size(), 1500U);
  for (std::size_t i = 0; i < names.size(); i += 10) {
    const auto feature = lunar_feature_named(names[i]);
    ASSERT_TRUE(feature) << names[i];
    EXPECT_LE(std::abs(in_degrees(feature->middle.latitude)), 90) << names[i];
    EXPECT_LE(std::abs(in_degrees(feature->middle.longitude)), 180) << names[i];
  }
}

}  // namespace
}  // namespace coppermoon::almanac
