// SPDX-License-Identifier: MIT
#include "eclipse/moment.h"

#include "algebra/error.h"
#include "support/within.h"

namespace coppermoon::eclipse {
namespace {

std::string text_of(const std::string& text,
                    almanac::Calendar calendar = almanac::Calendar::gregorian) {
  return almanac::utc_text(moment_in(text, calendar), 3);
}

std::string refusal_of(const std::string& text) {
  try {
    moment_in(text);
  } catch (const algebra::Error& error) {
    return error.what();
  }
  return "";
}

TEST(Moment, OfADayAndAContactCountsFromIt) {
  // Espenak & Meeus (2006): 2018 Jul 27, U2 at 19:30:15 UT
  for (const auto& [text, published] : {std::pair{"2018-07-27 U2", "2018-07-27T19:30:15Z"},
                                        std::pair{"2018-07-27 U2+10min", "2018-07-27T19:40:15Z"},
                                        std::pair{"2018-07-27 U2-0.5h", "2018-07-27T19:00:15Z"}})
    EXPECT_WITHIN(almanac::seconds_between(almanac::instant_from_utc(published), moment_in(text)),
                  0, 12, "s: what the contacts' published times are met by, at worst");
}

TEST(Moment, OfADayAloneIsItsGreatestEclipse) {
  EXPECT_EQ(text_of("2018-07-27"), text_of("2018-07-27 greatest"));
  EXPECT_TRUE(is_day("-0584-05-22"));
  EXPECT_FALSE(is_day("2018-07-27T00:00"));
  EXPECT_NE(refusal_of("2018-07-28").find("2018-07-28: no lunar eclipse"), std::string::npos);
}

TEST(Moment, OfAContactIsToTheFullSecond) {
  EXPECT_TRUE(text_of("2018-07-27 greatest").ends_with(".000Z"));
}

TEST(Moment, OfATimeOfDayIsThatTime) {
  EXPECT_EQ(text_of("2018-07-27T20:22:01.250Z"), "2018-07-27T20:22:01.250Z");
  EXPECT_EQ(text_of("2018-07-27 20:22"), "2018-07-27T20:22:00.000Z");
  EXPECT_FALSE(is_from_contact("2018-07-27 20:22"));
  EXPECT_TRUE(is_from_contact("2018-07-27 U2"));
}

TEST(Moment, OfAJulianDayIsOfThatDaysEclipse) {
  // the Peterborough Chronicle's eclipse of 5 May 1110
  EXPECT_EQ(text_of("1110-05-05 greatest", almanac::Calendar::julian).substr(0, 10), "1110-05-12");
}

TEST(Moment, OfAJulianDayIsRefusedInJulianDates) {
  try {
    eclipse_on("1504-03-02", almanac::Calendar::julian);
    FAIL() << "an eclipse on the day after Columbus'";
  } catch (const algebra::Error& error) {
    EXPECT_NE(std::string(error.what()).find("1504-03-02: no lunar eclipse"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("the nearest is at 1504-03-01T00:"), std::string::npos)
        << error.what();
  }
  EXPECT_EQ(eclipse_on("1504-03-01", almanac::Calendar::julian).calendar,
            almanac::Calendar::julian);
}

TEST(Moment, OfNothingIsRefusedWithWhatIsAllowed) {
  EXPECT_NE(refusal_of("2018-07-28 U2").find("the nearest is at 2018-07-27T20:2"),
            std::string::npos);
  EXPECT_NE(refusal_of("2018-07-27 U5").find("P1, U1, U2, greatest"), std::string::npos);
  EXPECT_NE(refusal_of("2018-07-27 U2+10weeks").find("as P1-10min"), std::string::npos);
  EXPECT_NE(refusal_of("2018-07-27 U2+1000h").find("as P1-10min"), std::string::npos);
  EXPECT_NE(refusal_of("2020-01-10 U1").find("P1, greatest, P4"), std::string::npos)
      << "penumbral alone";
}

}  // namespace
}  // namespace coppermoon::eclipse
