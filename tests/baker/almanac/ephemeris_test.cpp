// SPDX-License-Identifier: MIT
#include "almanac/ephemeris.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "support/testing.h"

namespace coppermoon::almanac::ephemeris_test {

constexpr double arcsecond = std::numbers::pi / 648000;

/// The ecliptic of J2000 as JPL's Horizons turns it: about X by 84381.448″.
glm::dvec3 ecliptic_from_gcrs(const glm::dvec3& p) {
  const double obliquity = 84381.448 * arcsecond;
  const double c = std::cos(obliquity), s = std::sin(obliquity);
  return {p.x, c * p.y + s * p.z, -s * p.y + c * p.z};
}

/// Where the Moon was in truth: seen when its light arrives.
glm::dvec3 geometric_moon_km(const Instant& instant, LunarTheory theory) {
  const double light_time_s =
      glm::length(apparent_moon_m(instant, theory)) / speed_of_light_m_per_s;
  return 1e-3 * ecliptic_from_gcrs(apparent_moon_m(later(instant, light_time_s), theory));
}

const struct {
  Instant tdb;
  glm::dvec3 moon_km;
} horizons[] = {{{2451545.0, 0}, {-291608.38, -274979.74, 36271.20}},
                {{2444239.5, 0}, {43890.30, 381188.87, -31633.44}}};

TEST(Moon, TheFullTheoryIsWithinAKilometreOfDe441) {
  for (const auto& [tdb, moon_km] : horizons)
    EXPECT_WITHIN(
        glm::distance(geometric_moon_km(tdb, LunarTheory::elp_2000_82b), moon_km), 0, 1.0,
        "JPL Horizons, DE441, geocentric; ELP 2000-82B was fitted to DE200: 0.5″ is 1 km");
}

TEST(Moon, TheFastTheoryIsWithinItsStatedWorst) {
  for (const auto& [tdb, moon_km] : horizons)
    EXPECT_WITHIN(glm::distance(geometric_moon_km(tdb, LunarTheory::moon98), moon_km), 0, 34,
                  "JPL Horizons, DE441; ERFA states 18.3″ worst: 34 km");
}

TEST(Moon, TheTwoTheoriesKeepTogetherFrom1500To2500) {
  for (double year = 1500; year <= 2500; year += 100) {
    double sum_m = 0;
    for (int i = 0; i < 12; ++i) {
      const Instant instant{2451544.5 + std::floor((year - 2000) * 365.25) + 31 * i, 0};
      const auto gap_m = apparent_moon_m(instant, LunarTheory::moon98) -
                         apparent_moon_m(instant, LunarTheory::elp_2000_82b);
      sum_m += glm::dot(gap_m, gap_m) / 12;
    }
    EXPECT_WITHIN(std::sqrt(sum_m) / 3.844e8 / arcsecond, 0, 5,
                  "2.9″ RMS is moon98's own; without the tidal term they part by 23″ in 1500")
        << year;
  }
}

}  // namespace coppermoon::almanac::ephemeris_test
