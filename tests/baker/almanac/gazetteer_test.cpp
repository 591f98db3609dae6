// SPDX-License-Identifier: MIT
#include "almanac/gazetteer.h"

#include <unistd.h>
#include <cstdlib>

#include "support/testing.h"

namespace coppermoon::almanac::gazetteer_test {

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
  EXPECT_FALSE(city_named("Ȁ")) << "no Romanian letter, though its first byte is one's";
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
  EXPECT_FALSE(city_named("Paris, Texas"));
  EXPECT_FALSE(city_named(", Illinois"));
  EXPECT_EQ(no_such_city("Paris, Texas"), "no such city; Paris is known in Ile-de-France");
  EXPECT_EQ(no_such_city("Springfield, Ohio"),
            "no such city; Springfield is known in Missouri, Massachusetts, Illinois");
  EXPECT_EQ(no_such_city("Atlantis"), "no such city");
}

TEST(Gazetteer, ACountryOrAStatesCodeMayStandBehindAComma) {
  for (const auto& [name, zone] : {std::pair{"Berlin, Germany", "Europe/Berlin"},
                                   {"Berlin, DE", "Europe/Berlin"},
                                   {"Paris, France", "Europe/Paris"},
                                   {"London, UK", "Europe/London"},
                                   {"London, Canada", "America/Toronto"},
                                   {"London, Ontario, Canada", "America/Toronto"},
                                   {"Abidjan, Côte d'Ivoire", "Africa/Abidjan"},
                                   {"Washington, D.C.", "America/New_York"},
                                   {"Washington, DC, USA", "America/New_York"}}) {
    ASSERT_TRUE(city_named(name)) << name;
    EXPECT_EQ(city_named(name)->time_zone, zone) << name;
  }
  EXPECT_EQ(city_named("Springfield, IL")->region, "Illinois");
  EXPECT_EQ(city_named("Springfield, MA, USA")->region, "Massachusetts");
  EXPECT_EQ(city_named("Zanzibar/Zanzibar Urban/West")->name, "Zanzibar");
  EXPECT_FALSE(city_named("London, Germany"));
  EXPECT_FALSE(city_named("Springfield, IL, Canada"));
}

TEST(Gazetteer, EveryCitysTimeZoneIsThatOfACountry) {
  std::set<std::string> zones;
  std::ifstream areas(COPPERMOON_TEST_DATA "/../baker/almanac/data/areas.csv");
  for (std::string line; std::getline(areas, line);) {
    std::istringstream names(line.substr(line.rfind(',') + 1));
    for (std::string zone; names >> zone;) zones.insert(zone);
  }
  for (const auto& city : largest_cities(100'000))
    EXPECT_TRUE(zones.contains(city.time_zone)) << city.name << ": " << city.time_zone;
}

/// User's file of cities, there before the gazetteer first looks for it.
const bool has_own_cities = [] {
  const auto folder = std::filesystem::temp_directory_path() /
                      ("coppermoon_own_cities_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder / "coppermoon");
  std::ofstream(folder / "coppermoon" / "cities.csv")
      << "# mine\nname,region,latitude_deg,longitude_deg,elevation_m,time_zone\n"
         "My garden,,52.4,13.1,40,Europe/Berlin\nKiritimati,,1.87,-157.4,3,Pacific/Kiritimati\n";
  ::setenv("XDG_CONFIG_HOME", folder.c_str(), 1);
  std::atexit([] { std::filesystem::remove_all(std::getenv("XDG_CONFIG_HOME")); });
  return true;
}();

TEST(Gazetteer, CitiesOfTheUsersOwnAreKnownByNameAndNearby) {
  ASSERT_TRUE(has_own_cities);
  const auto garden = city_named("my garden");
  ASSERT_TRUE(garden && garden->own);
  EXPECT_EQ(in_metres(garden->place.elevation), 40);
  EXPECT_EQ(city_taken("My garden"), "");
  EXPECT_EQ(nearest_city(garden->place).name, "My garden");
  const auto island = nearest_city({algebra::degrees(2), algebra::degrees(-157), {}});
  EXPECT_EQ(island.time_zone, "Pacific/Kiritimati");
  EXPECT_EQ(city_names().front(), "My garden");
  EXPECT_FALSE(largest_cities(1).front().own) << "a page for others holds no place of one's own";
}

TEST(Gazetteer, DistancesAreAlongTheGlobe) {
  const auto london = city_named("London")->place, york = city_named("New York City")->place;
  EXPECT_WITHIN(in_kilometres(distance_between(london, york)), 5570, 20,
                "km: 5571 by the ellipsoid, to its flattening of 1/298");
  EXPECT_EQ(in_kilometres(distance_between(london, london)), 0);
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

}  // namespace coppermoon::almanac::gazetteer_test
