// SPDX-License-Identifier: MIT
#include "uses/light/air.h"

#include "almanac/instant.h"
#include "almanac/sky.h"
#include "support/testing.h"
#include "uses/light/danjon_air.h"

namespace coppermoon::uses::air_test {

using atmosphere::StratosphericAerosol;

constexpr double july = 2018.57;
const auto equinox = algebra::degrees(0);

/// The column over the middle of the limb.
atmosphere::Column middle(const atmosphere::Atmosphere& air) { return air.belts.at(6).column; }

TEST(AtmosphereOf, AMonthHasTheAirOfThatMonth) {
  const auto air = atmosphere_of({}, equinox, july);
  ASSERT_EQ(air.belts.size(), 13U);
  EXPECT_EQ(middle(air).density, atmosphere::Density::seasonal);
  EXPECT_EQ(middle(air).cloud_cover, 0);
  EXPECT_EQ(middle(atmosphere_of({.atmosphere = "standard"}, equinox, july)).ozone_du,
            middle(air).ozone_du)
      << "standard is that of the month";
  EXPECT_TRUE(atmosphere_of({.atmosphere = "undated"}, equinox, july).belts.empty());
}

TEST(AtmosphereOf, EachOfItsTermsHasASwitch) {
  Air asked;
  asked.density = atmosphere::Density::us_1976;
  asked.ozone_profile = OzoneProfile::us_1976;
  asked.oxygen_pairs = asked.oxygen_bands = asked.nitrogen_dioxide = false;
  asked.column = {.ozone_du = 300,
                  .stratosphere = StratosphericAerosol::background,
                  .tropopause_km = 12,
                  .cloud_chance = 0.5,
                  .cirrus = 0,
                  .free_troposphere = 0,
                  .water_vapour = 0};
  const auto column = middle(atmosphere_of(asked, equinox, july));
  EXPECT_EQ(column.density, atmosphere::Density::us_1976);
  EXPECT_EQ(column.ozone_climate, nullptr);
  EXPECT_EQ(column.ozone_du, 300);
  EXPECT_EQ(column.stratospheric_layer, nullptr);
  EXPECT_EQ(column.stratosphere, StratosphericAerosol::background);
  EXPECT_EQ(column.tropopause_m, 12e3);
  EXPECT_WITHIN(column.cloud_per_m, middle(atmosphere_of({}, equinox, july)).cloud_per_m / 2, 1e-20,
                "rounding");
  EXPECT_EQ(column.cirrus, 0);
  EXPECT_EQ(column.free_troposphere_per_m, 0);
  EXPECT_FALSE(column.oxygen_pairs || column.oxygen_bands || column.nitrogen_dioxide);
  EXPECT_EQ(column.water_vapour, 0);
}

TEST(AtmosphereOf, ADeckOfCloudStandsInPlaceOfTheChance) {
  const auto column = middle(atmosphere_of({.column = {.cloud_cover = 0.5}}, equinox, july));
  EXPECT_EQ(column.cloud_cover, 0.5);
  EXPECT_EQ(column.cloud_per_m, 0);
  EXPECT_EQ(column.cirrus, 0);
}

TEST(AtmosphereOf, WhatDependsOnTheLatitudeMakesBeltsOfAnyAir) {
  Air clear{.atmosphere = "clear"};
  EXPECT_TRUE(atmosphere_of(clear, equinox, july).belts.empty());
  clear.ozone_profile = OzoneProfile::climatology;
  const auto belts = atmosphere_of(clear, equinox, july).belts;
  ASSERT_EQ(belts.size(), 13U);
  EXPECT_GT(belts[2].column.ozone_du, belts[6].column.ozone_du + 20) << "60° and the equator";
  EXPECT_TRUE(atmosphere_of({.atmosphere = "none", .column = {.cloud_chance = 1}}, equinox, july)
                  .belts.empty())
      << "no air, no belts";
}

TEST(AtmosphereOf, FactorsAreOnWhatTheMonthHas) {
  const auto usual = middle(atmosphere_of({}, equinox, july));
  const auto more = middle(
      atmosphere_of({.column = {.stratospheric_factor = 2, .ozone_factor = 0.5}}, equinox, july));
  EXPECT_EQ(more.stratospheric_factor, 2);
  EXPECT_EQ(more.ozone_du, usual.ozone_du / 2);
  EXPECT_EQ(more.cloud_per_m, usual.cloud_per_m);
}

TEST(AtmosphereOf, RegionsChangeTheirBelts) {
  const Air asked{
      .regions = {{.from_latitude = -90, .to_latitude = 0, .column = {.stratosphere = 0.2}}}};
  const auto air = atmosphere_of(asked, equinox, july);
  ASSERT_EQ(air.regions.size(), 1U);
  ASSERT_EQ(air.regions[0].belts.size(), 13U);
  EXPECT_EQ(air.regions[0].belts[12].column.stratospheric_layer->optical_depth(), 0.2);
  EXPECT_LT(air.belts[12].column.stratospheric_layer->optical_depth(), 0.02);
}

// A great eruption adds to the stratosphere, and a bright eclipse has neither cloud nor aerosol.
TEST(DanjonScale, DarkensByTheStratosphereAndClearsAllThatDims) {
  const auto air = atmosphere_of({}, equinox, july);
  const auto dark = middle(cleared(air, -0.1)), bright = middle(cleared(air, 1));
  EXPECT_WITHIN(dark.stratospheric_layer->optical_depth(),
                middle(air).stratospheric_layer->optical_depth() + 0.1, 1e-12, "rounding");
  EXPECT_EQ(dark.cloud_per_m, middle(air).cloud_per_m);
  EXPECT_EQ(bright.cloud_per_m + bright.cirrus + bright.free_troposphere_per_m +
                bright.tropospheric_optical_depth + bright.stratospheric_layer->optical_depth(),
            0);
}

TEST(DanjonScale, IsTheSameForAllMomentsOfANightAndRefusesOtherDegrees) {
  const auto at = [](const char* utc) { return almanac::sky_at(almanac::instant_from_utc(utc)); };
  const Air asked{.column = {.danjon = 2}};
  const auto early = atmosphere_of(asked, at("2018-07-27T19:00:00Z")),
             late = atmosphere_of(asked, at("2018-07-27T21:30:00Z"));
  EXPECT_WITHIN_RELATIVE(middle(early).stratospheric_layer->optical_depth(),
                         middle(late).stratospheric_layer->optical_depth(), 1e-3,
                         "the air of two hours later");
  const Air five{.column = {.danjon = 5}};
  EXPECT_THROW(atmosphere_of(five, at("2018-07-27T19:00:00Z")), algebra::Error);
}

TEST(DanjonScale, FindsEachStepAlikeInAnyOrder) {
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2022-05-16T04:11:00Z"));
  const auto air = atmosphere_of({}, sky);
  DanjonScale rising(air, sky), falling(air, sky);
  std::array<double, 5> found;
  for (int l = 0; l <= 4; ++l) found.at(static_cast<std::size_t>(l)) = rising.clearness(l);
  EXPECT_TRUE(std::ranges::is_sorted(found));
  for (int l = 4; l >= 0; --l)
    EXPECT_EQ(falling.clearness(l), found.at(static_cast<std::size_t>(l))) << "same bytes";
}

TEST(ReachesDanjon, UnlessNoAirIsClearEnough) {
  const auto deep = almanac::sky_at(almanac::instant_from_utc("2018-07-27T20:21:45Z"));
  EXPECT_TRUE(reaches_danjon({}, deep));
  EXPECT_TRUE(reaches_danjon({.column = {.danjon = 2}}, deep));
  EXPECT_TRUE(reaches_danjon({.atmosphere = "undated", .column = {.danjon = 4}}, deep));
  EXPECT_FALSE(reaches_danjon({.column = {.danjon = 4}}, deep))
      << "by air alone it has no −3.8 mag";
}

}  // namespace coppermoon::uses::air_test
