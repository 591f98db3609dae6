// SPDX-License-Identifier: MIT
#include "uses/picture/moment_text.h"
#include "almanac/gazetteer.h"
#include "support/testing.h"
#include "uses/picture/view.h"

namespace coppermoon::uses::moment_text_test {

MomentContext at(const char* city, const std::string& zone = "") {
  return {almanac::city_named(city)->place, zone};
}

std::string text_of(const std::string& text, const MomentContext& context = {}) {
  return almanac::utc_text(moment_in(text, context), 3);
}

std::string refusal(const std::string& text, const MomentContext& context = {}) {
  return refusal_of([&] { moment_in(text, context); });
}

TEST(MomentText, OfADayAloneIsItsGreatestEclipse) {
  EXPECT_EQ(text_of("2018-07-27"), text_of("2018-07-27 greatest"));
  EXPECT_EQ(text_of("20180727"), text_of("2018-07-27"));
  EXPECT_SAYS(refusal("2018-07-28"),
              "2018-07-28: no lunar eclipse is greatest on that day (UTC); the nearest is "
              "at 2018-07-27T20:2");
}

TEST(MomentText, OfAContactIsToTheFullSecond) {
  EXPECT_TRUE(text_of("2018-07-27 greatest").ends_with(".000Z"));
}

TEST(MomentText, OfATimeOfDayIsThatTime) {
  EXPECT_EQ(text_of("2018-07-27T20:22:01.250Z"), "2018-07-27T20:22:01.250Z");
  EXPECT_EQ(text_of("2018-07-27 20:22"), "2018-07-27T20:22:00.000Z");
  EXPECT_EQ(text_of("2018-07-27 20:22", at("Nairobi")), "2018-07-27T20:22:00.000Z")
      << "UTC unless a zone is given";
}

TEST(MomentText, OfATimeOfDayIsByTheClocksOfTheZone) {
  EXPECT_EQ(text_of("2026-03-03 01:30", at("Honolulu", "local")), "2026-03-03T11:30:00.000Z");
  EXPECT_EQ(text_of("2018-07-27 23:21:45.500", at("Berlin", "Africa/Nairobi")),
            "2018-07-27T20:21:45.500Z");
  EXPECT_EQ(text_of("2018-07-27 23:21", {.zone = "+03:00"}), "2018-07-27T20:21:00.000Z");
  EXPECT_EQ(text_of("2018-07-27T20:21Z", at("Berlin", "local")), "2018-07-27T20:21:00.000Z");
  EXPECT_EQ(refusal("2018-07-27 20:22", {.zone = "local"}),
            "time zone = local: that of a place, and none is given");
  EXPECT_SAYS(refusal("2018-07-27", {.zone = "Moon/Tycho"}), "time zone = Moon/Tycho")
      << "also where no clock is read";
}

TEST(MomentText, OfADayIsOfThatDayAtThePlaceToo) {
  // NASA's catalogue: greatest at 2026-08-28 04:13 UT, 21:13 of 27 August in Los Angeles;
  // at 2025-03-14 06:59 UT, 02:59 in New York, in the night after 13 March
  EXPECT_EQ(text_of("2026-08-27", at("Los Angeles")), text_of("2026-08-28"));
  EXPECT_EQ(text_of("2026-08-28", at("Los Angeles")), text_of("2026-08-28"));
  EXPECT_EQ(text_of("2025-03-13", at("New York City")), text_of("2025-03-14"));
  EXPECT_EQ(text_of("2026-08-27", {.zone = "America/Los_Angeles"}), text_of("2026-08-28"));
  // 2018-07-27 20:22 UT is 06:22 of the 28th in Sydney
  EXPECT_EQ(text_of("2018-07-28 U2", at("Sydney")), text_of("2018-07-27 U2"));
  for (const char* other : {"2026-08-26", "2026-08-29", "2026-08-20"})
    EXPECT_SAYS(refusal(other, at("Los Angeles")), "(UTC or America/Los_Angeles)") << other;
  EXPECT_NE(refusal("2026-08-27"), "") << "UTC alone without a place";
  EXPECT_FALSE(eclipse_of_day("2026-08-20", at("Los Angeles")));
}

TEST(MomentText, CountsFromMoonriseAndMoonset) {
  const auto berlin = at("Berlin");
  const auto rise = moment_in("2025-09-07 moonrise", berlin),
             set = moment_in("2025-09-07 MOONSET", berlin);
  // timeanddate.com, Berlin, 7 September 2025: moonrise at 19:37 CEST
  EXPECT_WITHIN(almanac::seconds_between(almanac::instant_from_utc("2025-09-07T17:37Z"), rise), 0,
                180, "s: printed to the minute, for a city of some size");
  EXPECT_WITHIN(almanac::seconds_between(rise, moment_in("2025-09-07 moonrise+20min", berlin)),
                1200, 1e-4, "s: rounding of a day");
  const auto is_up = [&](const almanac::Instant& when) {
    return moon_is_up({.observer = berlin.observer}, almanac::sky_at(when));
  };
  EXPECT_TRUE(is_up(rise) && !is_up(almanac::later(rise, -2)));
  EXPECT_TRUE(is_up(set) && !is_up(almanac::later(set, 2)));
  EXPECT_EQ(refusal("2025-09-07 moonrise"),
            "moonrise and moonset are those of a place, and none is given");
  const MomentContext pole{almanac::Observer{algebra::degrees(89), {}, {}}};
  EXPECT_SAYS(refusal("2025-09-07 moonrise", pole), "allowed an instant or one of P1")
      << "the Moon does not rise there that day";
}

TEST(MomentText, OfAJulianDayIsOfThatDaysEclipse) {
  const MomentContext julian{.calendar = almanac::Calendar::julian};
  // the Peterborough Chronicle's eclipse of 5 May 1110
  EXPECT_EQ(text_of("1110-05-05 greatest", julian).substr(0, 10), "1110-05-12");
  EXPECT_SAYS(refusal("1504-03-02", julian), "the nearest is at 1504-03-01T00:")
      << "Columbus' eclipse";
  EXPECT_EQ(eclipse_on("1504-03-01", julian).calendar, almanac::Calendar::julian);
  const MomentContext jamaica{almanac::city_named("Kingston")->place, "",
                              almanac::Calendar::julian};
  EXPECT_EQ(text_of("1504-02-29", jamaica), text_of("1504-03-01", julian))
      << "the evening of 29 February, where Columbus was";
}

TEST(MomentText, OfNothingIsRefusedWithWhatIsAllowed) {
  EXPECT_SAYS(refusal("2018-07-28 U2"), "the nearest is at 2018-07-27T20:2");
  EXPECT_SAYS(refusal("2018-07-27 U5"), "P1, U1, U2, greatest");
  EXPECT_NE(refusal(""), "");
}

}  // namespace coppermoon::uses::moment_text_test
