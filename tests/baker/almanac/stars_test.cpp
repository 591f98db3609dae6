// SPDX-License-Identifier: MIT
#include "almanac/stars.h"

#include <erfa.h>
#include <erfam.h>
#include <glm/geometric.hpp>

#include "almanac/ephemeris.h"
#include "almanac/sky.h"
#include "support/testing.h"

namespace coppermoon::almanac::stars_test {

constexpr double degree = std::numbers::pi / 180, arcsec = degree / 3600, mas = arcsec / 1000;

glm::dvec3 direction(double right_ascension, double declination) {
  return {std::cos(declination) * std::cos(right_ascension),
          std::cos(declination) * std::sin(right_ascension), std::sin(declination)};
}

double separation(const glm::dvec3& one, const glm::dvec3& other) {
  return std::atan2(glm::length(glm::cross(one, other)), glm::dot(one, other));
}

/// A star as SIMBAD has it.
struct Published {
  const char* name;
  double hours, minutes, seconds, degrees, arcminutes, arcseconds;
  int sign;
  double motion_east_mas, motion_north_mas, magnitude, b_minus_v;

  double right_ascension() const { return 15 * (hours + minutes / 60 + seconds / 3600) * degree; }
  double declination() const {
    return sign * (degrees + arcminutes / 60 + arcseconds / 3600) * degree;
  }
};

constexpr Published alcyone{"Alcyone", 3, 47,    29.07655, 24,   6,
                            18.4883,   1, 19.34, -43.67,   2.87, -0.09};

/// ICRS, epoch 2000; motions of van Leeuwen (2007), Astron. Astrophys. 474, 653.
constexpr Published published[] = {
    {"Aldebaran", 4, 35, 55.23907, 16, 30, 33.4885, 1, 63.45, -188.94, 0.86, 1.54},
    {"Regulus", 10, 8, 22.31099, 11, 58, 1.9516, 1, -248.73, 5.59, 1.36, -0.09},
    {"Spica", 13, 25, 11.57937, 11, 9, 40.7501, -1, -42.35, -30.67, 0.98, -0.24},
    {"Antares", 16, 29, 24.45970, 26, 25, 55.2094, -1, -12.11, -23.30, 1.06, 1.86},
    {"Pollux", 7, 45, 18.94987, 28, 1, 34.3160, 1, -626.55, -45.80, 1.16, 0.99}};

const Star& nearest(const glm::dvec3& place) {
  return *std::ranges::min_element(stars(), {},
                                   [&](const Star& star) { return separation(star.place, place); });
}

TEST(Stars, StandAndMoveAsPublished) {
  for (const auto& star : published) {
    SCOPED_TRACE(star.name);
    const auto place = direction(star.right_ascension(), star.declination());
    const auto& found = nearest(place);
    EXPECT_WITHIN(separation(found.place, place) / arcsec, 0., 0.02,
                  "the file was made of single-precision triangles: up to 0.015″");
    const glm::dvec3 east = glm::normalize(glm::cross(glm::dvec3(0, 0, 1), place));
    const char* reason = "printed to 0.01 mas a year";
    EXPECT_WITHIN(glm::dot(found.motion_per_year, east) / mas, star.motion_east_mas, 0.02, reason);
    EXPECT_WITHIN(glm::dot(found.motion_per_year, glm::cross(place, east)) / mas,
                  star.motion_north_mas, 0.02, reason);
    EXPECT_WITHIN(found.magnitude, star.magnitude, 0.06, "steps of 0.05, and rounding");
    EXPECT_WITHIN(found.b_minus_v, star.b_minus_v, 0.03, "steps of 0.0315, and rounding");
  }
}

TEST(Stars, OfThePleiadesStandWhereHipparcosSawThem) {
  const auto place = direction(alcyone.right_ascension(), alcyone.declination());
  const auto& found = nearest(place);
  EXPECT_WITHIN(separation(found.place, place) / arcsec, 0.42, 0.02,
                "stars.h: 8.75 years of 0.048″; single-precision triangles");
  EXPECT_WITHIN(found.magnitude, alcyone.magnitude, 0.06, "steps of 0.05, and rounding");
  EXPECT_WITHIN(found.b_minus_v, alcyone.b_minus_v, 0.03, "steps of 0.0315, and rounding");
}

TEST(Stars, AreAsManyAsTheSkyHas) {
  const auto brighter = [&](double limit) {
    return std::ranges::count_if(stars(), [=](const Star& s) { return s.magnitude < limit; });
  };
  EXPECT_WITHIN_RELATIVE(
      static_cast<double>(brighter(6)), 5000., 0.05,
      "Allen's Astrophysical Quantities: some 4 800 to V = 6.0 and their companions");
  EXPECT_WITHIN(static_cast<double>(brighter(1.5)), 22., 3., "21 of first magnitude; doubles");
}

TEST(Stars, AreFainterBesideTheMoonAlone) {
  const double obliquity = 23.4393 * degree;
  double beside = -2, elsewhere = -2;
  for (const auto& star : stars()) {
    const double latitude =
        std::asin(star.place.z * std::cos(obliquity) - star.place.y * std::sin(obliquity));
    auto& faintest = std::abs(latitude) < 10 * degree ? beside : elsewhere;
    faintest = std::max(faintest, star.magnitude);
  }
  EXPECT_WITHIN(beside, 9, 1e-9, "to 9.0");
  EXPECT_WITHIN(elsewhere, 6.5, 1e-9, "to 6.5");
}

TEST(Stars, AreDirections) {
  for (const auto& star : stars())
    EXPECT_WITHIN(glm::length(star.place), 1., 1e-12, "a direction is a unit vector");
}

/// θ Persei, 2028 November 13.19 TD, as a book works it out.
TEST(Stars, ApparentPlaceIsThatOfAWorkedExample) {
  const double declination = (49 + 13 / 60. + 42.48 / 3600) * degree,
               right_ascension = 15 * (2 + 44 / 60. + 11.986 / 3600) * degree;
  const auto place = direction(right_ascension, declination);
  const glm::dvec3 east = glm::normalize(glm::cross(glm::dvec3(0, 0, 1), place));
  const Star star{place, 4.1, 0.5,
                  15 * 0.03425 * std::cos(declination) * arcsec * east -
                      0.0895 * arcsec * glm::cross(place, east)};
  const Instant when{2462088.5, 0.19};
  const glm::dvec3 seen = equator_from_gcrs(when) * apparent_directions({star}, when).front();
  const auto expected = direction(15 * (2 + 46 / 60. + 14.390 / 3600) * degree,
                                  (49 + 21 / 60. + 7.45 / 3600) * degree);
  EXPECT_WITHIN(separation(seen, expected) / arcsec, 0., 0.1,
                "Meeus (1998), example 23.a: 0.01 s of right ascension; without aberration 19″");
}

TEST(Stars, ApparentPlacesAreThoseOfErfa) {
  for (const auto& published_star : published)
    for (const double days : {-36525., 0., 6782., 8347., 36525.}) {
      const Instant when{ERFA_DJ00, days};
      const double a = published_star.right_ascension(), d = published_star.declination();
      const auto place = direction(a, d);
      const glm::dvec3 east = glm::normalize(glm::cross(glm::dvec3(0, 0, 1), place));
      constexpr double bent = 40;  // closer to the Sun light is bent by more than 0.011″
      if (separation(place, apparent_sun_m(when)) < bent * degree) continue;
      const Star star{place, 1, 0,
                      mas * (published_star.motion_east_mas * east +
                             published_star.motion_north_mas * glm::cross(place, east))};
      double right_ascension, declination, origins;
      eraAtci13(a, d, published_star.motion_east_mas * mas / std::cos(d),
                published_star.motion_north_mas * mas, 0, 0, when.tt_day, when.tt_fraction,
                &right_ascension, &declination, &origins);
      const auto expected = direction(right_ascension - origins, declination);
      const glm::dvec3 seen = equator_from_gcrs(when) * apparent_directions({star}, when).front();
      EXPECT_WITHIN(separation(seen, expected) / arcsec, 0., 0.015,
                    "the Sun bends light by 0.004″ at 90°, 0.011″ at 40°");
    }
}

}  // namespace coppermoon::almanac::stars_test
