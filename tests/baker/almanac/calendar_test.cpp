// SPDX-License-Identifier: MIT
#include "almanac/calendar.h"

#include "support/testing.h"

namespace coppermoon::almanac::calendar_test {

TEST(Calendar, OfJuliusHasHistorysDates) {
  const auto julian = [](const char* date) { return date_in(Calendar::julian, date); };
  EXPECT_EQ(julian("1504-03-11"), "1504-03-01") << "Columbus' eclipse, the evening of 29 February";
  EXPECT_EQ(julian("1582-10-14"), "1582-10-04") << "the day before 15 October, Gregorian";
  EXPECT_EQ(julian("-0584-05-22"), "-0584-05-28") << "Thales' eclipse";
  EXPECT_EQ(julian("0000-01-01"), "0000-01-03");
  EXPECT_EQ(date_in(Calendar::gregorian, "1504-03-11"), "1504-03-11");
}

TEST(Calendar, IsWrittenAsItIsRead) {
  for (const char* text :
       {"-1999-03-01T00:00:00.000Z", "-0584-05-28T15:07:00.250Z", "0000-02-29T23:59:59.999Z",
        "1100-02-29T12:00:00.000Z", "1504-03-01T00:47:01.000Z", "2100-02-29T06:30:00.000Z"})
    EXPECT_EQ(utc_text(instant_from_utc(text, Calendar::julian), Calendar::julian, 3), text);
}

TEST(Calendar, HasDateAndTimeOfDayInYearsOfAnySign) {
  for (const char* year : {"2018", "-0584"}) {
    const auto when = instant_from_utc(std::string(year) + "-07-27T20:21:45Z");
    EXPECT_EQ(date_text(when), std::string(year) + "-07-27");
    EXPECT_EQ(time_of_day_text(when), "20:21:45");
  }
}

TEST(Calendar, RoundsToTheNearestMinute) {
  const auto rounded = [](const char* utc) {
    return utc_text(to_the_minute(instant_from_utc(utc)));
  };
  EXPECT_EQ(rounded("2026-03-03T18:11:49Z"), "2026-03-03T18:12:00Z");
  EXPECT_EQ(rounded("2026-03-03T18:11:29Z"), "2026-03-03T18:11:00Z");
  EXPECT_EQ(rounded("2018-12-31T23:59:30Z"), "2019-01-01T00:00:00Z") << "the date follows";
  EXPECT_EQ(rounded("-0584-05-22T15:07:31Z"), "-0584-05-22T15:08:00Z");
}

}  // namespace coppermoon::almanac::calendar_test
