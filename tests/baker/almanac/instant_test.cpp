// SPDX-License-Identifier: MIT
#include "almanac/instant.h"

#include "support/testing.h"

namespace coppermoon::almanac::instant_test {

double julian_day_ut(const Instant& instant) {
  return instant.tt_day + instant.tt_fraction - delta_t_s(instant) / 86400;
}

std::string refusal(const char* text) {
  return refusal_of([&] { instant_from_utc(text); });
}

TEST(Instant, TheEpochJ2000IsNoonTerrestrialTime) {
  const Instant epoch = instant_from_utc("2000-01-01T11:58:55.816Z");
  EXPECT_WITHIN(seconds_between({2451545.0, 0}, epoch), 0, 1e-6,
                "TT − UTC was 64.184 s by definition; two-part dates keep better than 1 µs");
}

TEST(Instant, TheEclipseOfThalesIsOnItsJulianDay) {
  const double day = julian_day_ut(instant_from_utc("-0584-05-22T15:07"));
  EXPECT_WITHIN(day, 1507900.13, 0.005, "Meeus (1998), chapter 7, gives two decimals of a day");
}

TEST(Instant, SputnikIsOnItsJulianDay) {
  const double day = julian_day_ut(instant_from_utc("1957-10-04T19:26:24Z"));
  EXPECT_WITHIN(day, 2436116.31, 1e-6, "Meeus (1998), example 7.a, exact: 4.81 October");
}

TEST(Instant, ReadsAndWritesTheSameText) {
  for (const char* text :
       {"-1999-01-01T00:00:00.000Z", "-0584-05-22T16:00:00.000Z", "0000-02-29T12:00:00.000Z",
        "1582-10-15T00:00:00.001Z", "1971-06-30T00:00:00.000Z", "1972-01-01T00:00:00.000Z",
        "2008-02-21T03:26:05.999Z", "2016-12-31T23:59:60.500Z", "2027-01-01T00:00:00.000Z",
        "3000-12-31T23:59:59.000Z"})
    EXPECT_EQ(utc_text(instant_from_utc(text), 3), text);
}

TEST(Instant, SecondsTimeOfDayAndZoneLetterMayBeLeftOut) {
  EXPECT_EQ(utc_text(instant_from_utc("2008-02-21T03:26")), "2008-02-21T03:26:00Z");
  EXPECT_EQ(utc_text(instant_from_utc("2008-02-21")), "2008-02-21T00:00:00Z");
}

TEST(Instant, ASpaceStandsForTheTAndAnOffsetForTheZ) {
  EXPECT_EQ(utc_text(instant_from_utc("2008-02-21 03:26")), "2008-02-21T03:26:00Z");
  EXPECT_EQ(utc_text(instant_from_utc("2008-02-21T07:26:05+04:00")), "2008-02-21T03:26:05Z");
  EXPECT_EQ(utc_text(instant_from_utc("2008-02-20T22:26:05-05")), "2008-02-21T03:26:05Z");
  EXPECT_EQ(utc_text(instant_from_utc("2008-02-21 08:56+0530")), "2008-02-21T03:26:00Z");
  for (const char* wrong : {"2008-02-21T03:26+19:00", "2008-02-21T03:26+01:60", "2008-02-21+01:00",
                            "2008-02-21T03:26Z+01:00", "2008-02-21T03:26+1"})
    EXPECT_NE(refusal(wrong), "") << wrong;
}

TEST(Instant, IsReadInSmallLettersAndInIsosBasicFormat) {
  for (const char* text : {"20180727T202145Z", "2018-07-27t20:21:45z", "20180727t202145",
                           "2018-07-27T202145Z", "20180727T232145+0300"})
    EXPECT_EQ(utc_text(instant_from_utc(text)), "2018-07-27T20:21:45Z") << text;
  EXPECT_EQ(utc_text(instant_from_utc("20180727T2021")), "2018-07-27T20:21:00Z");
  EXPECT_EQ(utc_text(instant_from_utc("20180727")), "2018-07-27T00:00:00Z");
  for (const char* wrong : {"2018-0727", "201807-27", "20180727T20214", "20180727T20", "2018727"})
    EXPECT_NE(refusal(wrong), "") << wrong;
}

TEST(Instant, TwentyFourHoursAreTheEndOfTheDay) {
  EXPECT_EQ(utc_text(instant_from_utc("2018-07-27T24:00Z")), "2018-07-28T00:00:00Z");
  EXPECT_EQ(utc_text(instant_from_utc("2018-12-31T24:00:00-01:00")), "2019-01-01T01:00:00Z");
  EXPECT_EQ(utc_text(instant_from_utc("1100-02-28T24:00", Calendar::julian)),
            utc_text(instant_from_utc("1100-02-29", Calendar::julian)));
  for (const char* wrong : {"2018-07-27T24:01Z", "2018-07-27T25:00Z", "2018-07-27T24:00:00.1Z"})
    EXPECT_NE(refusal(wrong), "") << wrong;
}

TEST(Instant, ALeapSecondIsToldInAnyZone) {
  for (const char* text : {"2016-12-31T15:59:60-08:00", "2017-01-01T05:29:60+05:30"})
    EXPECT_EQ(utc_text(instant_from_utc(text)), "2016-12-31T23:59:60Z") << text;
  EXPECT_EQ(utc_text(instant_from_utc("2016-12-31T16:00:00-08:00")), "2017-01-01T00:00:00Z")
      << "the leap second lies between the clock's midnight and this moment";
  for (const char* wrong : {"2016-12-31T23:59:60-08:00", "2016-12-31T15:58:60-08:00"})
    EXPECT_NE(refusal(wrong), "") << wrong;
}

TEST(Instant, JulianDatesAreOnTheirJulianDays) {
  const auto day_of = [](const char* text) {
    return julian_day_ut(instant_from_utc(text, Calendar::julian));
  };
  const char* exact = "Meeus (1998), chapter 7: exact";
  EXPECT_WITHIN(day_of("-0584-05-28T15:07"), 1507900.13, 0.005,
                "Meeus (1998), chapter 7, gives two decimals of a day");
  EXPECT_WITHIN(day_of("0333-01-27T12:00"), 1842713.0, 1e-6, exact);
  EXPECT_WITHIN(day_of("0837-04-10T07:12"), 2026871.8, 1e-6, exact);
  EXPECT_WITHIN(day_of("-1000-07-12T12:00"), 1356001.0, 1e-6, exact);
  EXPECT_WITHIN(day_of("-1001-08-17T21:36"), 1355671.4, 1e-6, exact);
  EXPECT_WITHIN(day_of("1582-10-04T00:00") + 1, julian_day_ut(instant_from_utc("1582-10-15")), 1e-6,
                "the reform: the day after 4 October was the 15th");
  EXPECT_THROW(instant_from_utc("1101-02-29", Calendar::julian), algebra::Error);
  EXPECT_NO_THROW(instant_from_utc("1100-02-29", Calendar::julian));
}

TEST(Instant, RoundingCarriesThroughToTheYear) {
  EXPECT_EQ(utc_text(instant_from_utc("2007-12-31T23:59:59.6Z")), "2008-01-01T00:00:00Z");
  EXPECT_EQ(utc_text(instant_from_utc("2026-12-31T23:59:59.9996Z")), "2027-01-01T00:00:00Z");
}

TEST(Instant, ATextThatIsNoDateIsNamedWithAnExample) {
  EXPECT_EQ(
      refusal("next Tuesday"),
      "date \"next Tuesday\": allowed is an ISO 8601 date of the years -1999 to 3000, such as "
      "2026-03-03, 2026-03-03T11:33:43Z or 2026-03-03T13:33:43+02:00");
}

TEST(Instant, DatesThatDoNotExistAreRefused) {
  for (const char* text :
       {"", "2008-02-30", "2007-02-29", "2008-13-01", "2008-2-1", "3001-01-01", "-2000-01-01",
        "2008-02-21T24:00:01Z", "2008-02-21T03:60Z", "2008-02-21T03:26:60Z", "1950-01-01T23:59:60Z",
        "2008-02-21T03:26:05.Z", "2008-02-21T03:26:05+1:00", "2008-02-21T03:26:05ZZ"})
    EXPECT_THROW(instant_from_utc(text), algebra::Error) << text;
}

TEST(Instant, DecimalsOutsideTheirRangeAreRefused) {
  EXPECT_THROW(utc_text(Instant{2451545, 0}, 10), algebra::Error);
  EXPECT_THROW(utc_text(Instant{2451545, 0}, -1), algebra::Error);
}

TEST(Instant, ALeapSecondIsASecondLong) {
  const Instant before = instant_from_utc("2016-12-31T23:59:59Z"),
                after = instant_from_utc("2017-01-01T00:00:00Z");
  EXPECT_WITHIN(seconds_between(before, after), 2, 1e-6,
                "the last second of 2016 was a leap second");
}

TEST(Instant, LaterIsUndoneByEarlier) {
  const Instant start = instant_from_utc("2008-02-21T03:26:05Z");
  EXPECT_WITHIN(seconds_between(start, later(start, 1e6)), 1e6, 1e-6,
                "rounding of a day's fraction");
  EXPECT_WITHIN(seconds_between(start, later(later(start, 1e6), -1e6)), 0, 1e-6, "the same");
}

TEST(DeltaT, AgreesWithStephensonAndMorrison) {
  const struct {
    const char* date;
    double delta_s, uncertainty_s;
  } history[] = {
      {"-1000-01-01", 25400, 640}, {"-0500-01-01", 17190, 430}, {"0000-01-01", 10580, 260},
      {"0500-01-01", 5710, 140},   {"1000-01-01", 1570, 55},    {"1500-01-01", 200, 20},
      {"1600-01-01", 120, 20},     {"1700-01-01", 9, 5},        {"1800-01-01", 14, 1},
      {"1900-01-01", -3, 1},       {"1950-01-01", 29, 1}};
  for (const auto& known : history)
    EXPECT_WITHIN(delta_t_s(instant_from_utc(known.date)), known.delta_s, known.uncertainty_s,
                  "Stephenson & Morrison (2004) in Espenak & Meeus (2006), table 1: its own "
                  "uncertainty, or its rounding to 1 s");
}

TEST(DeltaT, IsCountedInLeapSecondsFrom1972) {
  EXPECT_WITHIN(delta_t_s(instant_from_utc("1972-01-01")), 42.184, 1e-6,
                "10 s + 32.184 s, defined");
  EXPECT_WITHIN(delta_t_s(instant_from_utc("2008-02-21")), 65.184, 1e-6,
                "33 s + 32.184 s, defined");
  EXPECT_WITHIN(delta_t_s(instant_from_utc("2020-01-01")), 69.184, 1e-6,
                "37 s + 32.184 s, defined");
}

TEST(DeltaT, StepsByLessThanATenthWhereThePolynomialsEnd) {
  const Instant seam = instant_from_utc("1972-01-01");
  EXPECT_WITHIN(delta_t_s(later(seam, -60)), delta_t_s(later(seam, 60)), 0.1,
                "UT1 − UTC at the time was −0.05 s: the polynomial gives UT1");
}

TEST(DeltaT, IsContinuousWhereThePredictionBegins) {
  Instant last = instant_from_utc("2020-01-01");
  while (!delta_t_is_predicted(last)) last = later(last, 86400);
  EXPECT_WITHIN(delta_t_s(last), delta_t_s(later(last, -86400)), 1e-3,
                "the parabola starts level: 32.5 s (1 d / 1 cy)² is under 1 µs");
}

TEST(DeltaT, IsAPredictionAfterTheTableOnly) {
  EXPECT_FALSE(delta_t_is_predicted(instant_from_utc("1900-01-01")));
  EXPECT_FALSE(delta_t_is_predicted(instant_from_utc("2025-09-07")));
  EXPECT_TRUE(delta_t_is_predicted(instant_from_utc("2100-01-01")));
}

}  // namespace coppermoon::almanac::instant_test
