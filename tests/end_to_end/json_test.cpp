// SPDX-License-Identifier: MIT
// Other programs rely on these keys, units and forms of time.
#include <nlohmann/json.hpp>

#include "support/csv_rows.h"
#include "support/program.h"

namespace coppermoon::end_to_end::json_test {

using nlohmann::json;
using Names = std::set<std::string>;

Names keys_of(const json& object) {
  Names names;
  for (const auto& [key, value] : object.items()) names.insert(key);
  return names;
}

/// Digits, and the letters and signs of 2008-02-21T03:26:05Z in their places.
void expect_utc(const json& text) {
  std::string shape = text.get<std::string>();
  for (char& c : shape)
    if (c >= '0' && c <= '9') c = '0';
  EXPECT_EQ(shape, "0000-00-00T00:00:00Z") << text;
}

void expect_keys(const json& object, const Names& wanted) {
  for (const auto& key : wanted) EXPECT_TRUE(object.contains(key)) << key;
}

class Json : public ProgramTest {};

TEST_F(Json, AlmanacListsEclipsesWithTypeMagnitudesAndContacts) {
  const auto all = json_of("almanac --from 2008-01-01 --to 2009-02-28");
  ASSERT_TRUE(all.is_array());
  ASSERT_EQ(all.size(), 3U);  // total, partial, penumbral: 21 February, 16 August, 9 February
  for (const auto& eclipse : all) {
    EXPECT_EQ(keys_of(eclipse), Names({"greatest", "type", "gamma", "umbral_magnitude",
                                       "penumbral_magnitude", "contacts"}));
    expect_utc(eclipse["greatest"]);
    for (const auto& when : eclipse["contacts"]) expect_utc(when);
  }
  EXPECT_EQ(all[0]["type"], "total");
  EXPECT_EQ(keys_of(all[0]["contacts"]), Names({"P1", "U1", "U2", "U3", "U4", "P4"}));
  EXPECT_EQ(all[1]["type"], "partial");
  EXPECT_EQ(keys_of(all[1]["contacts"]), Names({"P1", "U1", "U4", "P4"}));
  EXPECT_EQ(all[2]["type"], "penumbral");
  EXPECT_EQ(keys_of(all[2]["contacts"]), Names({"P1", "P4"}));
}

TEST_F(Json, AlmanacOfAMonthWithoutEclipseIsAnEmptyList) {
  EXPECT_EQ(json_of("almanac --from 2008-04-01 --to 2008-05-01"), json::array());
}

using JsonThoroughly = Json;

TEST_F(JsonThoroughly, AlmanacTakesEachConventionOfTheShadow) {
  const auto magnitude = [&](const char* convention) {
    return json_of(words_of("almanac --from 2008-02-01 --to 2008-03-01 --shadow-convention {}",
                            convention))[0]["umbral_magnitude"]
        .get<double>();
  };
  EXPECT_WITHIN(magnitude("danjon"), 1.1062, 0.001,
                "Espenak & Meeus' canon, Danjon's rule, 4 decimals");
  EXPECT_GT(magnitude("chauvenet"), magnitude("danjon"));
  EXPECT_NE(magnitude("herald-sinnott"), magnitude("danjon"));
  EXPECT_WITHIN(magnitude("danjon-oblate"), magnitude("danjon"), 0.003,
                "5″ to 6″ of the Moon's 1900″");
  EXPECT_NE(magnitude("danjon-oblate"), magnitude("danjon"));
}

TEST_F(Json, AlmanacSaysWhenTheUmbraCrossesAFeature) {
  const auto all = json_of("almanac --from 2007-03-01 --to 2009-02-28 --feature 23.7,-47.4");
  ASSERT_EQ(all.size(), 5U);
  const auto& aristarchus = all[0]["feature"];
  EXPECT_EQ(keys_of(aristarchus),
            Names({"latitude_deg", "longitude_deg", "immersion", "emersion"}));
  EXPECT_WITHIN(aristarchus["latitude_deg"].get<double>(), 23.7, 1e-12, "as given");
  EXPECT_WITHIN(aristarchus["longitude_deg"].get<double>(), -47.4, 1e-12, "as given");
  for (const char* key : {"immersion", "emersion"}) expect_utc(aristarchus[key]);
  const auto minute = [&](const char* key) {
    return aristarchus[key].get<std::string>().substr(0, 16);
  };
  EXPECT_EQ(minute("immersion"), "2007-03-03T21:54") << "Espenak's timing";
  EXPECT_EQ(minute("emersion"), "2007-03-04T00:06") << "Espenak's timing";
  EXPECT_EQ(all[4]["type"], "penumbral");
  EXPECT_EQ(keys_of(all[4]["feature"]), Names({"latitude_deg", "longitude_deg"}));
}

TEST_F(Json, AlmanacWithoutJsonHasTheFeatureInColumns) {
  const auto outcome = coppermoon("almanac --from 2007-03-01 --to 2007-04-01 --feature 23.7,-47.4");
  expect_done(outcome);
  for (const char* part : {"feature in", "feature out", "  21:54:", "  00:06:"})
    EXPECT_SAYS(outcome.out, part) << part << " in " << outcome.out;
}

TEST_F(Json, AlmanacAsCsvHasARowForEachEclipseAndAColumnForEachContact) {
  const auto outcome = coppermoon(
      "almanac --from 2008-02-01 --to 2009-02-28 --at Honolulu --feature 23.7,-47.4 --csv");
  expect_done(outcome);
  std::istringstream lines(outcome.out);
  std::vector<std::string> rows;
  for (std::string row; std::getline(lines, row);) rows.push_back(row);
  ASSERT_EQ(rows.size(), 4U) << outcome.out;
  EXPECT_EQ(rows[0],
            "greatest,type,gamma,umbral_magnitude,penumbral_magnitude,P1,U1,U2,U3,U4,P4,immersion,"
            "emersion,seen");
  for (const auto& row : rows) EXPECT_EQ(std::ranges::count(row, ','), 13) << row;
  EXPECT_SAYS(rows[3], ",penumbral,") << rows[3];
  EXPECT_SAYS(rows[3], ",,,,,2009-02-09T") << "U1 to U4: " << rows[3];
}

TEST_F(Json, SkyHasThePlacesOfMoonSunAndShadow) {
  const auto all = json_of("sky 2008-02-21T03:26:05Z");
  expect_keys(all, {"moon_ra_deg", "moon_dec_deg", "moon_distance_km", "sun_distance_au",
                    "sub_earth_latitude_deg", "sub_earth_longitude_deg", "sub_solar_latitude_deg",
                    "sub_solar_longitude_deg", "axis_position_angle_deg", "axis_distance_km"});
  EXPECT_FALSE(all.contains("altitude_deg"));
  EXPECT_WITHIN(all["axis_distance_km"].get<double>(), 0.3992 * 6378.137, 20,
                "gamma printed to 4 digits: 0.6 km; 1 minute");
  const auto seen = json_of("sky 2008-02-21T03:26:05Z --at 42.86,-73.77,100");
  expect_keys(seen, {"moon_ra_deg", "altitude_deg", "geometric_altitude_deg", "azimuth_deg"});
}

TEST_F(Json, SkyHasOnlyNumbersButForTheInstant) {
  const auto sky = json_of("sky 2008-02-21T03:26:05Z --at -33.9,18.4");
  for (const auto& [key, value] : sky.items())
    EXPECT_TRUE(key == "instant" || value.is_number()) << key;
}

TEST_F(Json, ShadowIsATableOfDistanceAndWavelength) {
  const auto all = json_of(
      "shadow --moon-distance-km 376400 --sun-distance-km 148000000 --wavelengths 450,650 "
      "--axis-distances 0,2000,4000 --rays 100");
  EXPECT_EQ(keys_of(all),
            Names({"moon_distance_km", "sun_distance_km", "solver", "seconds", "wavelengths_nm",
                   "axis_distance_km", "irradiance_ratio", "standard_error"}));
  EXPECT_EQ(all["moon_distance_km"], 376400);
  EXPECT_EQ(all["sun_distance_km"], 148000000);
  EXPECT_EQ(all["wavelengths_nm"], json({450, 650}));
  EXPECT_EQ(all["axis_distance_km"], json({0, 2000, 4000}));
  for (const char* key : {"irradiance_ratio", "standard_error"}) {
    ASSERT_EQ(all[key].size(), 3U) << key;
    for (const auto& row : all[key]) EXPECT_EQ(row.size(), 2U) << key;
  }
  EXPECT_GT(all["irradiance_ratio"][1][1], all["irradiance_ratio"][1][0]) << "the shadow is red";
}

TEST_F(Json, BrightnessHasMagnitudesLuminanceAndDanjon) {
  const auto all = json_of(
      "brightness 2008-02-21T03:26:05Z --rays 50 --albedo-map built-in --at 42.86,-73.77 -o "
      "a.json -o a.csv");
  expect_keys(all, {"magnitudes", "mean_luminance_cd_m2", "illuminance_lx", "danjon"});
  EXPECT_EQ(keys_of(all["magnitudes"]), Names({"B", "V", "R"}));
  EXPECT_TRUE(all["danjon"].is_number());
  EXPECT_GT(all["mean_luminance_cd_m2"], 0);
  auto file = json::parse(text_of(here("a.json")));
  file["files"] = {"a.json", "a.csv"};
  EXPECT_EQ(file, all);
  const auto rows = csv_rows(text_of(here("a.csv")));
  ASSERT_EQ(rows.size(), 2U) << "above the air, and as seen";
  EXPECT_EQ(rows[0].at("instant"), "2008-02-21T03:26:05Z");
  EXPECT_EQ(rows[0].at("altitude_deg"), "");
  EXPECT_EQ(std::stod(rows[1].at("altitude_deg")), all["seen"]["altitude_deg"]);
  EXPECT_EQ(std::stod(rows[0].at("V_magnitude")), all["magnitudes"]["V"]);
  EXPECT_EQ(std::stod(rows[1].at("V_magnitude")), all["seen"]["magnitudes"]["V"]);
  const auto calendar = coppermoon("brightness 2008-02-21T03:26:05Z -o a.ics");
  EXPECT_EQ(
      calendar.err,
      "coppermoon: --output: night and almanac write calendars (.ics); brightness writes .csv "
      "(table), .json (JSON document), .png (plot of a light curve), .svg (plot of a light curve), "
      ".pdf (plot of a light curve)\n");
}

TEST_F(Json, BrightnessOverTimeIsOneRowAMoment) {
  const auto all = json_of(
      "brightness 2008-02-21 --from U2-10min --to U2+10min --step 10 --rays 50 --bands 4 "
      "--albedo-map built-in --at Chicago --zone local -o v.json -o v.csv -o v.svg");
  const auto& moments = all["moments"];
  ASSERT_EQ(moments.size(), 3U);
  EXPECT_EQ(json::parse(text_of(here("v.json")))["moments"], moments);
  const auto rows = csv_rows(text_of(here("v.csv")));
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[2].at("instant"), moments[2]["instant"]);
  EXPECT_EQ(rows[2].at("local").substr(0, 14), "2008-02-20T21:");  // six hours behind UTC
  EXPECT_EQ(std::stod(rows[2].at("seen_V_magnitude")), moments[2]["seen_V_magnitude"]);
  EXPECT_EQ(rows[0].at("V_error"), "") << "not total yet";
  EXPECT_LT(moments[0]["V_magnitude"], moments[2]["V_magnitude"]);
  EXPECT_SAYS(text_of(here("v.svg")), ">U2<");
  const auto plot = coppermoon("brightness 2008-02-21 -o one.png");
  EXPECT_EQ(plot.status, 2);
  EXPECT_EQ(plot.err,
            "coppermoon: --output: a plot (.png) shows a light curve, allowed with --from or "
            "--to\n");
}

TEST_F(JsonThoroughly, BrightnessOfTheFullMoonIsTheBooks) {
  const auto all = json_of("brightness 2008-02-21T00:36:00Z --unshadowed --albedo-map built-in");
  EXPECT_WITHIN(
      all["magnitudes"]["V"].get<double>(), -12.74, 0.06,
      "Allen's full Moon at mean distances; 384 400 km and 1 au are 0.02 mag from that day's, the "
      "phase of 1.5 degrees is as near as it comes outside an eclipse");
  EXPECT_TRUE(all["danjon"].is_null());
}

TEST_F(Json, BakeSaysWhatWasChosenAndReached) {
  const auto all = json_of(
      "bake 2008-02-21T03:26:05Z --rays 50 --atmosphere undated --albedo-map built-in "
      "--texture-width 16 -o moon.exr");
  expect_keys(all, {"chosen", "reached"});
  EXPECT_EQ(keys_of(all["reached"]), Names({"seconds", "error"}));
  EXPECT_EQ(all["chosen"]["rays"], 50);
  EXPECT_EQ(all["chosen"]["instant"], "2008-02-21T03:26:05Z");
}

TEST_F(Json, DevelopSaysTheExposure) {
  expect_done(
      coppermoon("bake 2008-02-21T03:26:05Z --unshadowed --albedo-map built-in --texture-width 16 "
                 "-o moon_acescg.exr --space acescg"));
  const auto all = json_of("develop moon_acescg.exr -o moon.png");
  expect_keys(all, {"file", "colour_space", "time_s", "f_number", "iso"});
  EXPECT_EQ(all["colour_space"], "acescg");
}

TEST_F(Json, WithoutJsonPeopleGetAText) {
  const auto outcome = coppermoon("almanac --from 2008-01-01 --to 2008-12-31");
  expect_done(outcome);
  EXPECT_TRUE(json::parse(outcome.out, nullptr, false).is_discarded());
  EXPECT_SAYS(outcome.out, "2008-02-21T03:2");
}

/// Mars was at its opposition: V = -2.8, six degrees from the Moon.
TEST_F(Json, ListsTheStarsOfAnObserversSky) {
  const Words sky = "sky 2018-07-27 --at Nairobi --stars -2.5";
  const auto outcome = coppermoon(sky + Words{"--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto said = nlohmann::json::parse(outcome.out);
  EXPECT_GT(said["altitude_deg"], said["geometric_altitude_deg"]) << "raised by refraction";
  ASSERT_EQ(said["stars"].size(), 1U) << "Mars; Venus has set";
  const auto& mars = said["stars"][0];
  const double up = mars["altitude_deg"].get<double>() - said["altitude_deg"].get<double>();
  EXPECT_LT(std::abs(up), 7) << "degrees";
  const double lux = 0.2126 * mars["illuminance_lux"][0].get<double>() +
                     0.7152 * mars["illuminance_lux"][1].get<double>() +
                     0.0722 * mars["illuminance_lux"][2].get<double>();
  EXPECT_WITHIN(-13.98 - 2.5 * std::log10(lux), -2.6, 0.25,
                "V = -2.8 above the air, which takes 0.1 to 0.3 mag at 65 degrees");
  EXPECT_EQ(coppermoon(sky).err, "coppermoon: stars are listed with --at and --json\n");
}

}  // namespace coppermoon::end_to_end::json_test
