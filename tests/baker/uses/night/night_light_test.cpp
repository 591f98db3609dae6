// SPDX-License-Identifier: MIT
#include "uses/night/night_light.h"

#include <mutex>

#include "almanac/gazetteer.h"
#include "support/testing.h"

namespace coppermoon::uses::night_light_test {

std::mutex telling;
std::vector<double> fractions_told;  ///< while the lights were computed

const NightLights& of_july_2018() {
  static const auto lights = [] {
    const auto eclipse = *eclipse::eclipse_of_day(almanac::instant_from_utc("2018-07-27"),
                                                  eclipse::ShadowConvention::danjon);
    const auto place = almanac::city_named("Nairobi")->place;
    MoonRequest moon{.albedo_map = "built-in"};
    moon.light.wish.tolerance = 0.05;
    return night_lights(circumstances(eclipse, place), moon, {.observer = place}, {}, true,
                        [](double fraction) {
                          const std::lock_guard lock(telling);
                          fractions_told.push_back(fraction);
                        });
  }();
  return lights;
}

/// Exposure over what it needs: time times speed over the square of the f-number.
double exposure_of(const char* phase) {
  const auto& lights = of_july_2018();
  const auto found = std::ranges::find(lights.exposures, phase, &PhaseExposure::phase);
  return found->lit->time_s * lights.iso / (lights.f_number * lights.f_number);
}

double guided(double seconds, double f_number, double iso) {
  return seconds * iso / (f_number * f_number);
}

TEST(NightLight, ExposuresAreThoseOfPublishedGuides) {
  // eclipsechasers.com, "Photographing a lunar eclipse", ISO 100: full Moon 1/250 f/11, penumbra 1/60
  // f/11, second contact 1 s f/2.8, totality 2 s f/2. J. Cali, "Lunar eclipse photography", ISO 400
  // f/5.6: first contact and half immersed, sunlit side, 1/250
  const char* reason = "stops: the two guides differ by 4 of the full Moon";
  const auto stops = [](const char* phase, double guide) {
    return std::log2(exposure_of(phase) / guide);
  };
  EXPECT_WITHIN(stops("full Moon, before P1", guided(1 / 250., 11, 100)), 0, 3, reason);
  EXPECT_WITHIN(stops("full Moon, before P1", guided(1 / 250., 5.6, 400)), 0, 3, reason);
  EXPECT_WITHIN(stops("penumbral, just before U1", guided(1 / 60., 11, 100)), 0, 3, reason);
  EXPECT_WITHIN(stops("partial, half", guided(1 / 250., 5.6, 400)), 0, 3, reason);
  EXPECT_WITHIN(stops("totality, just after U2", guided(1, 2.8, 100)), 0, 3, reason);
  EXPECT_WITHIN(stops("middle of totality, L = 3", guided(2, 2, 100)), 0, 3, reason);
}

TEST(NightLight, DarkerEclipsesAreExposedLonger) {
  // Espenak, "How to photograph a lunar eclipse": two stops for each step of Danjon's scale; Vital's
  // magnitudes, which are ours, are 1 to 2.5 mag apart
  double last = exposure_of("middle of totality, L = 3");
  for (const char* phase :
       {"middle of totality, L = 2", "middle of totality, L = 1", "middle of totality, L = 0"}) {
    const double now = exposure_of(phase);
    EXPECT_GT(std::log2(now / last), 0.5) << phase;
    EXPECT_LT(std::log2(now / last), 5) << phase;
    last = now;
  }
}

TEST(NightLight, TheMoonIsBrightestOutsideTheShadow) {
  const auto& moments = of_july_2018().moments;
  ASSERT_EQ(moments.size(), 7U);
  EXPECT_WITHIN(moments.front().V_magnitude, -12.6, 0.2,
                "mag: a full Moon near apogee, Allen's -12.73 at mean distance");
  for (const auto& moment : moments) {
    EXPECT_GE(moment.V_magnitude, moments.front().V_magnitude - 0.05) << moment.name;
    EXPECT_GT(moment.faintest_star.value(), 2) << moment.name;
    EXPECT_LT(moment.faintest_star.value(), 7) << moment.name;
  }
  EXPECT_GT(*moments[3].faintest_star, *moments.front().faintest_star + 1.5) << "stars come out";
}

TEST(NightLight, ProgressIsToldThroughoutDanjonsScale) {
  of_july_2018();
  EXPECT_TRUE(std::ranges::all_of(fractions_told, [](double f) { return f >= 0 && f < 1.0001; }));
  for (const double end : {0.25, 0.4, 0.55, 0.7, 0.85, 1.}) {
    const auto near = [&](double fraction) { return std::abs(fraction - end) < 1e-6; };
    EXPECT_TRUE(std::ranges::any_of(fractions_told, near)) << end;
  }
}

const PhaseExposure* phase_of(const NightLights& lights, const char* name) {
  const auto found = std::ranges::find(lights.exposures, name, &PhaseExposure::phase);
  return found == lights.exposures.end() ? nullptr : &*found;
}

NightLights lights_of(const char* day, const char* city, MoonRequest moon = {},
                      ViewRequest view = {}, const Development& development = {}) {
  const auto eclipse =
      *eclipse::eclipse_of_day(almanac::instant_from_utc(day), eclipse::ShadowConvention::danjon);
  view.observer = almanac::city_named(city)->place;
  moon.albedo_map = "built-in";
  moon.light.wish.tolerance = 0.1;
  return night_lights(circumstances(eclipse, *view.observer), moon, view, development, false);
}

/// In April 2015 the Moon's limb was a hundred kilometres within the umbra: its edge is lit in air of any Danjon number,
/// its middle not at all.
TEST(NightLight, HasNoTimeLongerThanTheEclipse) {
  MoonRequest moon;
  moon.light.air.column.danjon = 0;
  Development pinhole;
  pinhole.f_number = 512;
  const auto lights = lights_of("2015-04-04", "Honolulu", moon, {}, pinhole);
  const auto* middle = phase_of(lights, "middle of totality");
  ASSERT_NE(middle, nullptr);
  EXPECT_FALSE(middle->shadow.has_value());
  EXPECT_TRUE(middle->too_dark);
  EXPECT_FALSE(lights.exposures.front().too_dark) << "a full Moon has no part in the umbra";
}

TEST(NightLight, HasNoStarByDayAndNoExposureOfAMoonBelowTheHorizon) {
  const auto lights = lights_of("2015-04-04", "London");  // noon
  for (const auto& moment : lights.moments) EXPECT_FALSE(moment.faintest_star) << moment.name;
  EXPECT_TRUE(lights.exposures.empty());
  EXPECT_TRUE(lights.night.seen.empty());
}

/// 7 September 2025: the Moon rose eclipsed over Berlin in civil twilight, and set over Sydney after U4.
TEST(NightLight, ExposesAMoonThatIsUpBeforeItsSky) {
  const auto lights = lights_of("2025-09-07", "Berlin");
  EXPECT_EQ(phase_of(lights, "full Moon, before P1"), nullptr) << "below the horizon";
  const auto* leaving = phase_of(lights, "partial, half, leaving");
  ASSERT_NE(leaving, nullptr) << "13 degrees high";
  EXPECT_TRUE(leaving->lit && leaving->shadow);
  const auto* middle = phase_of(lights, "middle of totality");
  ASSERT_NE(middle, nullptr);
  EXPECT_TRUE(middle->by_sky) << "the Sun is 5.5 degrees below the horizon";
  EXPECT_LT(middle->lit ? middle->lit->time_s : 0, 10) << "the sky alone is at half of saturation";
  const auto* late = phase_of(lights, "totality, just before U3");
  ASSERT_TRUE(late != nullptr && late->lit);
  EXPECT_LT(late->lit->least_s, late->lit->time_s) << "V is known to 0.27 mag";
  EXPECT_GT(late->lit->most_s, late->lit->time_s);
  for (std::size_t i = 1; i < lights.exposures.size(); ++i)
    EXPECT_GE(almanac::seconds_between(lights.exposures[i - 1].when, lights.exposures[i].when), 0);
  const auto first = std::ranges::find(lights.night.moments, "first seen", &NightMoment::name);
  ASSERT_NE(first, lights.night.moments.end());
  EXPECT_LT(algebra::in_degrees(first->sun_altitude), -4)
      << "long after moonrise, with the Sun at 0";
  EXPECT_GT(algebra::in_degrees(first->sun_altitude), -9) << "nautical twilight has begun";
  EXPECT_EQ(contacts_seen(lights.night).substr(contacts_seen(lights.night).find("to")), "to P4");
}

TEST(NightLight, NoTimeIsLongerThanTrailingAllows) {
  const auto lights = lights_of("2025-09-07", "Sydney", {}, {.focal_length_mm = 600});
  const double longest = lights.trailing_s.value();
  for (const auto& phase : lights.exposures)
    for (const auto& part : {phase.lit, phase.shadow})
      EXPECT_LE(part ? part->most_s : 0, longest * 1.000001) << phase.phase;
  const auto* middle = phase_of(lights, "middle of totality");
  ASSERT_TRUE(middle != nullptr && middle->lit);
  EXPECT_GT(middle->lit->stops_under, 4) << "15 s is wanted, 0.2 s is had";
}

TEST(NightLight, TheAlmanacHasTheSameRule) {
  const auto night = lights_of("2025-09-07", "Berlin").night;
  EXPECT_EQ(contacts_seen(seen_circumstances(night.eclipse, night.place)), contacts_seen(night));
}

TEST(TrailingTime, IsThatOfTheSkysRotation) {
  const auto eclipse = *eclipse::eclipse_of_day(almanac::instant_from_utc("2018-07-27"),
                                                eclipse::ShadowConvention::danjon);
  const auto night = circumstances(eclipse, almanac::city_named("Nairobi")->place);
  // at a declination of -19 degrees stars go by 15.04 cos 19 = 14.22 arcseconds in a second, and the Moon falls behind
  // by 0.5, less what Nairobi's own way of 0.46 km/s at 400 000 km takes off: 0.2
  const double arcsec = 14.22 - 0.5 + 0.2;
  EXPECT_WITHIN(trailing_time_s(night, 600, 10), 0.01 / (600 * arcsec / 206265), 0.005,
                "the Moon's own way to 0.2 arcseconds: 2 %");
  EXPECT_WITHIN_RELATIVE(trailing_time_s(night, 300, 5), trailing_time_s(night, 600, 10), 1e-9, "");
  EXPECT_THROW(trailing_time_s(night, 0.5, 10), algebra::Error);
}

TEST(CameraTime, IsTheNearestThatACameraHas) {
  EXPECT_EQ(camera_time_s(1 / 260.), 1 / 250.);
  EXPECT_EQ(camera_time_s(0.0078), 1 / 125.);
  EXPECT_EQ(camera_time_s(3), 3.2);
  EXPECT_EQ(camera_time_s(31), 30);
  EXPECT_EQ(camera_time_s(100), 100);
  EXPECT_EQ(camera_time_s(1e-9), 1 / 8000.);
}

}  // namespace coppermoon::uses::night_light_test
