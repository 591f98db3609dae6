// SPDX-License-Identifier: MIT
#include "almanac/planets.h"

#include <erfa.h>
#include <glm/geometric.hpp>

#include "almanac/ephemeris.h"
#include "almanac/observer.h"
#include "almanac/sky.h"
#include "support/testing.h"

namespace coppermoon::almanac::planets_test {

constexpr double degree = std::numbers::pi / 180, arcsec = degree / 3600;

Planet planet(std::string_view name, const Instant& when) {
  const auto planets = planets_at(when);
  return *std::ranges::find(planets, name, &Planet::name);
}

double separation(const glm::dvec3& one, const glm::dvec3& other) {
  return std::atan2(glm::length(glm::cross(one, other)), glm::dot(one, other));
}

double away_au(const Planet& planet) {
  return glm::length(planet.position_m) / astronomical_unit_m;
}

TEST(Planets, VenusIsWhereAWorkedExampleHasIt) {
  const Instant when{2448976.5, 0};  // 1992 December 20, 0 h TD
  const auto venus = planet("Venus", when);
  const double right_ascension = 15 * (21 + 4 / 60. + 41.454 / 3600) * degree,
               declination = -(18 + 53 / 60. + 16.84 / 3600) * degree;
  const glm::dvec3 expected(std::cos(declination) * std::cos(right_ascension),
                            std::cos(declination) * std::sin(right_ascension),
                            std::sin(declination));
  EXPECT_WITHIN(separation(equator_from_gcrs(when) * venus.position_m, expected) / arcsec, 0., 0.15,
                "Meeus (1998), example 33.a by the complete VSOP87, 0.1″ between FK5 and GCRS");
}

TEST(Planets, MarsOf2018IsAsNearAndBrightAsPublished) {
  const auto nearest = planet("Mars", instant_from_utc("2018-07-31T07:50Z"));
  EXPECT_WITHIN(away_au(nearest), 0.38496, 1e-5, "57.59 million km: JPL, five decimals");
  EXPECT_WITHIN(nearest.magnitude, -2.78, 0.1,
                "The Astronomical Almanac for 2018; how Mars is turned");
}

/// Mallama & Hilton (2018), the examples that come with their program: apparent magnitudes of Horizons' positions.
TEST(Planets, AreAsBrightAsInPublishedExamples) {
  struct Example {
    const char *name, *date;
    double magnitude, tolerance;
  };
  constexpr double omitted = 0.1;  // see the header's Omits
  for (const auto& [name, date, magnitude, tolerance] :
       {Example{"Mercury", "2006-05-19", -2.477, 0.01},
        Example{"Mercury", "2006-06-15", 0.181, 0.01}, Example{"Venus", "2006-10-28", -3.917, 2e-3},
        Example{"Venus", "2005-12-14", -4.916, 2e-3}, Example{"Venus", "2004-06-08", -3.090, 0.02},
        Example{"Mars", "2003-08-28", -2.862, omitted},
        Example{"Mars", "2004-07-19", 1.788, omitted},
        Example{"Jupiter", "2004-09-21", -1.667, 2e-3},
        Example{"Jupiter", "2010-09-21", -2.934, 2e-3},
        Example{"Saturn", "2032-12-25", -0.552, 0.01},
        Example{"Uranus", "1970-03-28", 5.381, omitted},
        Example{"Uranus", "2008-03-08", 6.025, omitted},
        Example{"Neptune", "1970-11-23", 7.997, 2e-3},
        Example{"Neptune", "2009-08-17", 7.701, 2e-3}})
    EXPECT_WITHIN(planet(name, instant_from_utc(date)).magnitude, magnitude, tolerance,
                  "three digits printed; a planet's day")
        << name << " " << date;
}

TEST(Planets, NeptuneOf1990IsHalfwayFromItsOldBrightnessToItsNew) {
  const auto at_one_au = [](const char* date) {
    const Instant when = instant_from_utc(date);
    const auto neptune = planet("Neptune", when);
    double heliocentric[2][3];
    eraPlan94(when.tt_day, when.tt_fraction, 8, heliocentric);
    const auto& [x, y, z] = heliocentric[0];
    return neptune.magnitude - 5 * std::log10(std::hypot(x, y, z) * away_au(neptune));
  };
  EXPECT_WITHIN(at_one_au("1990-01-01"), (at_one_au("1975-01-01") + at_one_au("2005-01-01")) / 2,
                1e-3, "mean elements' distances");
}

/// Where the planets stand by an independent, coarser theory.
TEST(Planets, AgreeWithErfasMeanElements) {
  constexpr double worst_arcsec[] = {4, 5, 0, 17, 71, 81, 86, 11};  // stated by ERFA, 1800 to 2050
  for (const char* date : {"1900-01-01", "1950-06-01", "2018-07-27T20:22Z", "2040-11-18"}) {
    const Instant when = instant_from_utc(date);
    const auto planets = planets_at(when);
    for (int number = 1, k = 0; number <= 8; ++number) {
      if (number == 3) continue;
      double heliocentric[2][3], earth[2][3], earth_barycentric[2][3];
      const double days = away_au(planets[static_cast<std::size_t>(k)]) * 499.004784 / 86400;
      eraPlan94(when.tt_day, when.tt_fraction - days, number, heliocentric);
      eraEpv00(when.tt_day, when.tt_fraction, earth, earth_barycentric);
      glm::dvec3 seen;
      for (int axis = 0; axis < 3; ++axis) seen[axis] = heliocentric[0][axis] - earth[0][axis];
      const double nearness =
          glm::length(glm::dvec3(heliocentric[0][0], heliocentric[0][1], heliocentric[0][2])) /
          glm::length(seen);
      EXPECT_WITHIN(separation(seen, planets[static_cast<std::size_t>(k)].position_m) / arcsec, 0.,
                    2 * worst_arcsec[number - 1] * nearness + 25,
                    "twice what ERFA states, seen from the Earth, and aberration of 20.5″");
      ++k;
    }
  }
}

/// Mars below the Moon at mid-totality.
TEST(Planets, MarsStandsSixDegreesFromTheMoonOf2018) {
  const auto when = instant_from_utc("2018-07-27T20:22Z");
  const auto sky = sky_at(when);
  const auto mars = planet("Mars", when);
  EXPECT_WITHIN(separation(mars.position_m, sky.moon_m) / degree, 6.3, 0.6, "the press: 6 degrees");
  const auto place = equatorial_place(sky, mars.position_m),
             moon = equatorial_place(sky, sky.moon_m);
  EXPECT_LT(algebra::in_degrees(place.declination), algebra::in_degrees(moon.declination) - 5);
}

TEST(Planets, SaturnsRingsAndNeptunesRiseAreCounted) {
  EXPECT_WITHIN(planet("Saturn", instant_from_utc("2017-06-15")).magnitude, 0.0, 0.1,
                "The Astronomical Almanac: 0.0 at opposition, rings wide open");
  EXPECT_WITHIN(planet("Saturn", instant_from_utc("2009-03-08")).magnitude, 0.5, 0.1,
                "The Astronomical Almanac: 0.5 at opposition, rings edge on");
  EXPECT_WITHIN(planet("Neptune", instant_from_utc("2018-09-07")).magnitude, 7.8, 0.12,
                "The Astronomical Almanac, to 0.1; it is brighter by 0.1 than its older formula");
  EXPECT_WITHIN(planet("Jupiter", instant_from_utc("2018-05-09")).magnitude, -2.5, 0.1,
                "The Astronomical Almanac at opposition");
  EXPECT_WITHIN(planet("Uranus", instant_from_utc("2022-11-09")).magnitude, 5.64, 0.1,
                "The Astronomical Almanac: 5.6 to 5.7 at opposition");
}

/// Uranus behind the eclipsed Moon of 8 November 2022: begin of disappearance and of reappearance by the
/// National Astronomical Observatory of Japan, whole minutes of Japan Standard Time.
TEST(Planets, UranusGoesBehindTheMoonOf2022WhenPublished) {
  struct City {
    const char* name;
    double latitude, longitude;
    const char *gone, *back;
  };
  const City cities[] = {{"Naha", 26.21, 127.68, "2022-11-08T11:13Z", "2022-11-08T11:54Z"},
                         {"Tokyo", 35.66, 139.74, "2022-11-08T11:40Z", "2022-11-08T12:22Z"},
                         {"Sapporo", 43.06, 141.35, "2022-11-08T11:49Z", "2022-11-08T12:47Z"}};
  for (const auto& city : cities) {
    SCOPED_TRACE(city.name);
    const Observer observer{algebra::degrees(city.latitude), algebra::degrees(city.longitude), {}};
    /// Edge: of the planet, 1 the one that is further from the Moon's middle, −1 the other.
    const auto clear_rad = [&](const Instant& when, int edge) {
      const auto sky = sky_at(when);
      const auto view = view_from(observer, sky);
      const auto uranus = planet("Uranus", when);
      const glm::dvec3 to_uranus = uranus.position_m - view.position_m;
      return separation(to_uranus, sky.moon_m - view.position_m) -
             std::asin(lunar_radius / view.moon_distance) +
             edge * algebra::in_metres(uranus.radius) / glm::length(to_uranus);
    };
    const auto crossing_s = [&](const char* published, int edge) {
      const auto from = instant_from_utc(published);
      double before = -180, after = 240;
      const bool clear_before = clear_rad(later(from, before), edge) > 0;
      EXPECT_NE(clear_before, clear_rad(later(from, after), edge) > 0);
      while (after - before > 0.5) {
        const double middle = (before + after) / 2;
        const bool clear = clear_rad(later(from, middle), edge) > 0;
        (clear == clear_before ? before : after) = middle;
      }
      return before;
    };
    const char* reason = "seconds are cut off; 8 s for the Moon's mountains and where in the city";
    EXPECT_WITHIN(crossing_s(city.gone, -1), 30., 38., reason);
    EXPECT_WITHIN(crossing_s(city.back, 1), 30., 38., reason);
  }
}

}  // namespace coppermoon::almanac::planets_test
