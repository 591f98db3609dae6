// SPDX-License-Identifier: MIT
#include "uses/picture/brightness.h"

#include <glm/geometric.hpp>

#include "almanac/gazetteer.h"
#include "support/testing.h"
#include "uses/light/photometer.h"

namespace coppermoon::uses::brightness_test {

const char* const first = "2004-10-28T00:00:00Z";
constexpr double step_min = 20;

/// From before P1 (00:06) to after P4 (06:02), seen from Chicago, where the Moon is up all the time.
struct Night {
  MoonRequest moon;
  ViewRequest view{.observer = almanac::city_named("Chicago")->place};
  LightCurve curve;

  Night() {
    moon.light.by_hand = {.bands = 10, .rays = 200};
    const auto from = almanac::instant_from_utc(first);
    curve =
        light_curve(moon, moments_between(from, almanac::later(from, 6.2 * 3600), step_min), view);
  }
  const std::vector<double>& operator[](const std::string& name) const {
    return std::ranges::find(curve.columns, name, &result::Column::first)->second;
  }
  /// Number of the moment at or before a time of that day.
  std::size_t at(const std::string& time) const {
    const auto when = almanac::instant_from_utc("2004-10-28T" + time + "Z");
    return static_cast<std::size_t>(
        almanac::seconds_between(curve.moments[0].brightness.instant, when) / (60 * step_min) +
        1e-6);
  }
};

const Night& night() {
  static const Night all;
  return all;
}

TEST(LightCurve, IsTheBrightnessOfItsMoments) {
  for (const char* time : {"01:20", "02:40", "03:00"}) {  // partial, total, near greatest
    const auto i = night().at(time);
    const auto one = brightness_of(
        night().moon, almanac::sky_at(night().curve.moments[i].brightness.instant), night().view);
    for (std::size_t k = 0; k < photometric_bands().size(); ++k) {
      const std::string band = photometric_bands()[k].name + std::string("_magnitude");
      EXPECT_WITHIN(night()[band][i], one.disc.magnitudes[k], 0.003, "stated: 180 rows for 360");
      EXPECT_WITHIN(night()["seen_" + band][i], one.seen->disc.magnitudes[k], 0.003, "the same");
    }
    EXPECT_WITHIN_RELATIVE(night()["illuminance_lx"][i], one.disc.illuminance_lx, 0.003,
                           "0.003 mag");
    EXPECT_WITHIN_RELATIVE(
        night()["seen_level_illuminance_lx"][i],
        one.seen->disc.illuminance_lx * std::sin(algebra::in_radians(one.seen->moon.altitude)),
        0.003, "0.003 mag");
  }
}

TEST(LightCurve, BeginsWithTheFullMoon) {
  // V = −12.7 at mean distances and a phase of 1.5° (Allen's Astrophysical Quantities)
  const auto sky = almanac::sky_at(night().curve.moments[0].brightness.instant);
  const double away = glm::length(sky.moon_m) / 384.4e6,
               sun_au = glm::length(sky.sun_m - sky.moon_m) / almanac::astronomical_unit_m,
               V = night()["V_magnitude"][0] - 5 * std::log10(away * sun_au);
  EXPECT_WITHIN(V, -12.7, 0.1, "Allen's 0.05; a phase of 1.4 to 1.6°: 0.02; two digits");
  EXPECT_WITHIN(night()["V_magnitude"].back(), night()["V_magnitude"][0], 0.1,
                "the phase after P4 is another by some tenths of a degree");
}

TEST(LightCurve, FallsAsMuchAsAPhotometerSaw) {
  // R. W. Schmude: 10.61 ± 0.15 mag at greatest eclipse (03:04) below the Moon uneclipsed
  const auto& V = night()["V_magnitude"];
  EXPECT_WITHIN(V[night().at("03:00")] - V[0], 10.61, 0.5,
                "twice the 0.23 mag of weather that V_error states, and the photometer's 0.15");
  EXPECT_WITHIN(night()["V_error"][night().at("03:00")], 0.25, 0.1, "0.23, and the aerosol's");
}

TEST(LightCurve, DarkensFromP1ToTotalityAndBrightensFromItsEnd) {
  const auto& V = night()["V_magnitude"];
  const auto begin = static_cast<long>(night().at("00:20")),
             U2 = static_cast<long>(night().at("02:23")),
             U3 = static_cast<long>(night().at("03:45")) + 1, end = static_cast<long>(V.size()) - 1;
  EXPECT_TRUE(std::is_sorted(V.begin() + begin, V.begin() + U2 + 1));
  EXPECT_TRUE(std::is_sorted(V.begin() + U3, V.begin() + end, std::greater<>()));
}

TEST(LightCurve, DarkensTheSkyAroundTheMoonInTotality) {
  const auto& sky = night()["sky_cd_m2"];
  EXPECT_LT(10 * sky[night().at("03:00")], sky[night().at("05:40")]);
}

TEST(LightCurve, OfAPlaceThatDoesNotSeeTheMoonHasItAboveTheAirAlone) {
  auto tokyo = night().view;
  tokyo.observer = almanac::city_named("Tokyo")->place;
  auto moon = night().moon;
  moon.unshadowed = true;
  const auto curve = light_curve(moon, {almanac::instant_from_utc(first)}, tokyo);
  for (const auto& [name, numbers] : curve.columns)
    EXPECT_EQ(std::isnan(numbers[0]), name == "V_error" || name.starts_with("seen_") ||
                                          name.ends_with("_deg") || name == "sky_cd_m2")
        << name;
}

TEST(MomentsBetween, AreEvenAndEndAtOrBeforeTheLast) {
  const auto from = almanac::instant_from_utc(first);
  const auto moments = moments_between(from, almanac::later(from, 601), 5);
  ASSERT_EQ(moments.size(), 3U);
  EXPECT_WITHIN(almanac::seconds_between(from, moments[2]), 600., 1e-3, "rounding of days");
  EXPECT_THROW(moments_between(from, almanac::later(from, -1), 5), algebra::Error);
  EXPECT_THROW(moments_between(from, almanac::later(from, 86401), 5), algebra::Error);
  EXPECT_THROW(moments_between(from, from, 0), algebra::Error);
}

}  // namespace coppermoon::uses::brightness_test
