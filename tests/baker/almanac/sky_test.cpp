// SPDX-License-Identifier: MIT
#include "almanac/sky.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "almanac/lunar_orientation.h"
#include "baker/almanac/published_rows.h"
#include "support/testing.h"

namespace coppermoon::almanac::sky_test {

using algebra::in_degrees;

constexpr const char* table = "baker/almanac/data/moon_places.csv";

TEST(Sky, TheMoonsPlaceAgreesWithDe431) {
  for (const auto& row : published_rows(table)) {
    const SkyState sky = sky_at(instant_from_utc(row.at("utc")));
    const auto place = equatorial_place(sky, sky.moon_m);
    const char* reason = "Swiss Ephemeris on DE431, its ΔT up to 0.3 s off ours: 0.15″, 0.00005°";
    EXPECT_WITHIN(in_degrees(place.right_ascension), number(row, "moon_ra_deg"), 1e-4, reason);
    EXPECT_WITHIN(in_degrees(place.declination), number(row, "moon_dec_deg"), 1e-4, reason);
    EXPECT_WITHIN(algebra::in_kilometres(place.distance), number(row, "moon_distance_km"), 1.0,
                  "ELP 2000-82B was fitted to DE200, and 0.3 s of ΔT");
  }
}

TEST(Sky, TheApparentSunIsThatOfAWorkedExample) {
  const SkyState sky = sky_at({2448908.5, 0}, LunarTheory::moon98);  // 1992 October 13, 0 h TT
  const auto place = equatorial_place(sky, sky.sun_m);
  const double right_ascension_deg = 15 * (13 + 13 / 60.0 + 30.749 / 3600),
               declination_deg = -(7 + 47 / 60.0 + 1.74 / 3600);
  const char* reason = "Meeus (1998), example 25.b: 0.1″; without aberration it is off by 19″";
  EXPECT_WITHIN(in_degrees(place.right_ascension), right_ascension_deg, 0.1 / 3600, reason);
  EXPECT_WITHIN(in_degrees(place.declination), declination_deg, 0.1 / 3600, reason);
  EXPECT_WITHIN(algebra::in_metres(place.distance) / astronomical_unit_m, 0.99760853, 1e-7,
                "example 25.b's full VSOP87 radius; 15 km");
}

TEST(Sky, TheSunsDistanceAgreesWithDe431) {
  for (const auto& row : published_rows(table)) {
    const SkyState sky = sky_at(instant_from_utc(row.at("utc")), LunarTheory::moon98);
    EXPECT_WITHIN(glm::length(sky.sun_m) / astronomical_unit_m, number(row, "sun_distance_au"),
                  1e-7, "seven decimals in the table; eraEpv00 states 5 km RMS");
  }
}

TEST(Sky, LibrationSunAndAxisAgreeWithAnIndependentReading) {
  const char* reason = "the goal; seen with aberration both points differ by 20.5″ = 0.0057°";
  for (const auto& row : published_rows(table)) {
    const SkyState sky = sky_at(instant_from_utc(row.at("utc")));
    EXPECT_WITHIN(in_degrees(sky.sub_earth.latitude), number(row, "sub_earth_latitude_deg"), 0.01,
                  reason);
    EXPECT_WITHIN(in_degrees(sky.sub_earth.longitude), number(row, "sub_earth_longitude_deg"), 0.01,
                  reason);
    EXPECT_WITHIN(in_degrees(sky.sub_solar.latitude), number(row, "sub_solar_latitude_deg"), 0.01,
                  reason);
    EXPECT_WITHIN(in_degrees(sky.sub_solar.longitude), number(row, "sub_solar_longitude_deg"), 0.01,
                  reason);
    EXPECT_WITHIN(in_degrees(sky.axis_position_angle), number(row, "axis_position_angle_deg"), 0.01,
                  "the table's north is mean, ours true: nutation is under 0.003°");
  }
}

TEST(Sky, TheSubsolarPointIsThatOfAWorkedExample) {
  const SkyState sky = sky_at({2448724.5, 0}, LunarTheory::moon98);  // 1992 April 12, 0 h TT
  const char* reason =
      "Meeus (1998), example 53.b, optical libration alone: the physical is 0.03°; as from the "
      "Earth "
      "the longitude is 0.137° off";
  EXPECT_WITHIN(in_degrees(sky.sub_solar.longitude), 67.89, 0.03, reason);
  EXPECT_WITHIN(in_degrees(sky.sub_solar.latitude), 1.461, 0.03, reason);
}

TEST(Sky, TheMoonsFaceIsAsItsLightLeftIt) {
  const SkyState sky = sky_at(instant_from_utc("2008-02-21T03:26:05Z"), LunarTheory::moon98);
  const glm::dmat3 turned =
      selenographic_from_gcrs(sky.when) * glm::transpose(sky.selenographic_from_gcrs);
  const double turn_rad = (turned[1][0] - turned[0][1]) / 2;  // about the pole
  const double light_time_s = glm::length(sky.moon_m) / 299792458;
  EXPECT_WITHIN_RELATIVE(std::abs(turn_rad),
                         2 * std::acos(-1.0) / (27.321661 * 86400) * light_time_s, 0.01,
                         "the sidereal month; physical libration changes by 0.1 % of that");
}

TEST(Sky, TheRotationsAreRotations) {
  const SkyState sky = sky_at(instant_from_utc("2008-02-21T03:26:05Z"), LunarTheory::moon98);
  for (const glm::dmat3& m : {sky.selenographic_from_gcrs, sky.equator_from_gcrs}) {
    const glm::dmat3 unit = glm::transpose(m) * m;
    EXPECT_WITHIN(glm::determinant(m), 1, 1e-12, "rounding; a mirror gives −1");
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) EXPECT_WITHIN(unit[i][j], i == j ? 1.0 : 0.0, 1e-12, "rounding");
  }
}

TEST(Sky, TheMoonsPoleStandsWhereCassiniPutsIt) {
  const SkyState sky = sky_at(instant_from_utc("2008-02-21T03:26:05Z"), LunarTheory::moon98);
  const glm::dvec3 pole = glm::transpose(sky.selenographic_from_gcrs)[2];
  const double obliquity = 84381.4 / 3600 * std::acos(-1.0) / 180;
  const glm::dvec3 ecliptic_pole{0, -std::sin(obliquity), std::cos(obliquity)};
  EXPECT_WITHIN(std::acos(glm::dot(pole, ecliptic_pole)) * 180 / std::acos(-1.0), 1.543, 0.05,
                "Cassini's third law: 1.543° to the ecliptic; physical librations are 0.04°");
}

TEST(PositionAngle, RunsFromNorthThroughEast) {
  const glm::dvec3 ahead{1, 0, 0}, north{0, 0, 1};  // from the equinox east is +Y
  EXPECT_WITHIN(in_degrees(position_angle(ahead, {1, 0, 0.1}, north)), 0, 1e-9, "rounding");
  EXPECT_WITHIN(in_degrees(position_angle(ahead, {1, 0.1, 0}, north)), 90, 1e-9, "rounding");
  EXPECT_WITHIN(in_degrees(position_angle(ahead, {1, -0.1, 0}, north)), -90, 1e-9, "rounding");
}

}  // namespace coppermoon::almanac::sky_test
