// SPDX-License-Identifier: MIT
// The Moon as a whole, against what observers measured.
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "almanac/sky.h"
#include "support/program.h"

namespace coppermoon::end_to_end::brightness_test {

class Brightness : public ProgramTest {
 protected:
  nlohmann::json of(const Words& words) const {
    return json_of(Words{"brightness"} + words + "--albedo-map built-in --texture-width 512");
  }
};

TEST_F(Brightness, OfTheFullMoonFollowsFromItsGeometricAlbedo) {
  // m = m_sun − 2.5 lg(p (R/d)²), Sun and Moon at the distances of that moment.
  const auto full = of("2008-02-21T03:26:00Z --unshadowed --photometry yapo-cutler");
  const double sun_au = 0.98880 + 383.6e3 / 149.598e6, moon_km = 383.6e3;
  const double m =
      -26.76 + 5 * std::log10(sun_au) - 2.5 * std::log10(0.12 * std::pow(1737.4 / moon_km, 2));
  EXPECT_WITHIN(full["magnitudes"]["V"].get<double>(), m, 0.02,
                "p is of luminance, not of V: 0.01; the sub-Earth point is not longitude 0: 0.01");
  EXPECT_TRUE(full["danjon"].is_null());
}

TEST_F(Brightness, OfTheFullMoonAtMeanDistancesIsAllens) {
  const char* instant = "2008-02-21T00:36:00Z";
  const auto sky = almanac::sky_at(almanac::instant_from_utc(instant));
  const auto to_sun = sky.sun_m - sky.moon_m;
  const double moon_m = glm::length(sky.moon_m), sun_m = glm::length(to_sun);
  const double phase_deg =
      std::acos(glm::dot(to_sun, -sky.moon_m) / sun_m / moon_m) * 180 / std::numbers::pi;
  ASSERT_NEAR(phase_deg, 1.5, 0.02);
  const double V = of({instant, "--unshadowed"})["magnitudes"]["V"];
  const double reduced =
      V - 5 * std::log10(moon_m / 384.4e6) - 5 * std::log10(sun_m / almanac::astronomical_unit_m);
  EXPECT_WITHIN(reduced, -12.7, 0.05,
                "Allen's Astrophysical Quantities: −12.7 and p = 0.12, "
                "which is −12.73");
}

TEST_F(Brightness, OfTheFullMoonIsRedderThanTheSunAsMeasured) {
  // Full Moon B − V = 0.92, the Sun 0.653 (Allen's Astrophysical Quantities).
  const auto m = of("2008-02-21T03:26:00Z --unshadowed")["magnitudes"];
  EXPECT_WITHIN(m["B"].get<double>() - m["V"].get<double>(), 0.92, 0.06,
                "one Apollo 16 soil stands for the whole Moon");
}

// The paper's air and dust; the standard air is held against six eclipses elsewhere.
const Words paper = "--atmosphere paper --dust-extinction 4.7e-6";

Words in_the_papers_air(const std::string& instant) { return Words{instant} + paper; }

TEST_F(Brightness, OfTheEclipseOf2008IsWhatObserversSaw) {
  // H. C. Vital, REA Brazil: magnitude −2.8 ± 0.3, Danjon 3.0 ± 0.1 at mid-eclipse.
  const auto eclipsed = of(in_the_papers_air("2008-02-21T03:26:00Z"));
  EXPECT_WITHIN(eclipsed["magnitudes"]["V"].get<double>(), -2.8, 0.3, "the observers' spread");
  EXPECT_WITHIN(eclipsed["danjon"].get<double>(), 3.0, 0.4,
                "0.3 magnitudes are 0.3 of Danjon's scale");
}

TEST_F(Brightness, OfTheEclipseOf2004IsWhatObserversSaw) {
  // 13 observers, H. C. Vital, REA Brazil: magnitude −2.2 ± 0.2.
  const auto eclipsed = of(in_the_papers_air("2004-10-28T03:04:00Z"));
  EXPECT_WITHIN(eclipsed["magnitudes"]["V"].get<double>(), -2.2, 0.2, "the observers' spread");
}

}  // namespace coppermoon::end_to_end::brightness_test
