// SPDX-License-Identifier: MIT
#include "uses/night/circumstances.h"

#include "almanac/gazetteer.h"
#include "eclipse/seen_sky.h"
#include "result/as_json.h"
#include "support/testing.h"
#include "uses/night/calendar_file.h"
#include "uses/picture/local_time.h"

namespace coppermoon::uses::circumstances_test {

eclipse::Eclipse eclipse_of(const char* day) {
  return *eclipse::eclipse_of_day(almanac::instant_from_utc(day),
                                  eclipse::ShadowConvention::danjon);
}

Circumstances at(const char* day, const char* city) {
  return circumstances(eclipse_of(day), almanac::city_named(city)->place);
}

const NightMoment& moment(const Circumstances& night, const char* name) {
  return *std::ranges::find(night.moments, name, &NightMoment::name);
}

/// A clock time, its city's.
std::string clock_at(const char* day, const char* city, const char* name) {
  const auto night = at(day, city);
  const auto local = local_time(moment(night, name).when, almanac::city_named(city)->time_zone);
  return local.date + " " + local.time + " " + local.abbreviation;
}

/// Minutes from a published time to ours, for a city at the level of the sea, as almanacs print it.
double minutes_from(const char* day, const char* city, const char* name, const char* utc) {
  auto place = almanac::city_named(city)->place;
  place.elevation = {};
  const auto night = circumstances(eclipse_of(day), place);
  return almanac::seconds_between(almanac::instant_from_utc(utc), moment(night, name).when) / 60;
}

TEST(Circumstances, AreOnTheClocksOfTheirCities) {
  // Espenak's published times of the contacts in UT (U2 of 2018: 19:30:15, of 2022-05-16: 3:29:03, U1 of
  // 2026-03-03: 9:50:00), by the time zones of each country in that month
  EXPECT_EQ(clock_at("2018-07-27", "Nairobi", "U2").substr(0, 16), "2018-07-27 22:30");
  EXPECT_EQ(clock_at("2018-07-27", "Kolkata", "U2").substr(0, 16), "2018-07-28 01:00");
  EXPECT_EQ(clock_at("2018-07-27", "Kolkata", "U2").substr(20), "IST");
  EXPECT_EQ(clock_at("2022-05-16", "Chicago", "U2").substr(0, 16), "2022-05-15 22:29");
  EXPECT_EQ(clock_at("2022-05-16", "Chicago", "U2").substr(20), "CDT");
  EXPECT_EQ(clock_at("2026-03-03", "Honolulu", "U1").substr(0, 16), "2026-03-02 23:50");
}

TEST(Circumstances, TheMoonRisesAndSetsByAlmanacs) {
  // By the U.S. Naval Observatory's definition, as newspapers printed it: London, 27 July 2018, Moonrise
  // 20:49 BST; New York, 8 November 2022, Moonset 6:41 EST, and 31 January 2018, 7:06 EST
  const char* reason = "minutes: the size of a city, and rounding to one";
  EXPECT_WITHIN(minutes_from("2018-07-27", "London", "moonrise", "2018-07-27T19:49Z"), 0, 2,
                reason);
  EXPECT_WITHIN(minutes_from("2022-11-08", "New York", "moonset", "2022-11-08T11:41Z"), 0, 2,
                reason);
  EXPECT_WITHIN(minutes_from("2018-01-31", "New York", "moonset", "2018-01-31T12:06Z"), 0, 2,
                reason);
}

TEST(Circumstances, TheLimbStandsInTheHorizonAtRise) {
  const auto night = at("2018-07-27", "London");
  const auto& rise = moment(night, "moonrise");
  const auto view = almanac::view_from(night.place, almanac::sky_at(rise.when));
  const double limb_deg = algebra::in_degrees(view.altitude) +
                          std::asin(almanac::lunar_radius / view.moon_distance) * 57.29578;
  const double lowered_deg = 2.12 / 60 * std::sqrt(algebra::in_metres(night.place.elevation));
  EXPECT_WITHIN(limb_deg, -34. / 60 - lowered_deg, 1e-4, "degrees: 0.02 s of the Moon's way");
  EXPECT_WITHIN(result::as_json(eclipse::SeenSky{{}, view})["altitude_deg"].get<double>(),
                algebra::in_degrees(rise.moon.altitude), 1e-9,
                "`sky` has the same altitude as `night`: rounding");
  EXPECT_FALSE(moment(night, "U1").up);
  EXPECT_TRUE(moment(night, "greatest").up);
}

/// With the shadow of that yearbook, larger by a fiftieth.
double angle_deg(const char* day, const char* contact) {
  const auto eclipse = *eclipse::eclipse_of_day(almanac::instant_from_utc(day),
                                                eclipse::ShadowConvention::chauvenet);
  const auto night = circumstances(eclipse, almanac::city_named("Nairobi")->place);
  return algebra::in_degrees(moment(night, contact).position_angle.value());
}

TEST(Circumstances, ContactsAreAtPublishedAnglesOnTheLimb) {
  // Astronomical Yearbook of the Institute of Applied Astronomy, St Petersburg: position angles of the umbra's first and
  // last contact, and of the penumbra's where the eclipse is penumbral
  const char* reason = "degrees: the shadow's radius to 4 arcseconds";
  EXPECT_WITHIN(angle_deg("2011-06-15", "U1"), 92 + 15.2 / 60, 0.1, reason);
  EXPECT_WITHIN(angle_deg("2011-06-15", "U4"), 261 + 15.5 / 60, 0.1, reason);
  EXPECT_WITHIN(angle_deg("2015-04-04", "U1"), 133 + 45.7 / 60, 0.1, reason);
  EXPECT_WITHIN(angle_deg("2005-04-24", "P1"), 71 + 52.4 / 60, 0.1, reason);
  EXPECT_WITHIN(angle_deg("2005-04-24", "P4"), 338 + 51.6 / 60, 0.1, reason);
  EXPECT_WITHIN(angle_deg("2016-03-23", "P1"), 154 + 22.1 / 60, 0.1, reason);
  EXPECT_WITHIN(angle_deg("2016-03-23", "P4"), 241 + 10.1 / 60, 0.1, reason);
  // of a central eclipse the limb that goes in last is opposite to the one that went in first
  EXPECT_WITHIN(angle_deg("2011-06-15", "U2") - angle_deg("2011-06-15", "U1"), 180, 25,
                "degrees: the Moon passes 0.1 of its diameter beside the axis");
  EXPECT_FALSE(moment(at("2011-06-15", "Nairobi"), "greatest").position_angle.has_value());
}

TEST(Circumstances, TwilightIsNamedByTheSunsAltitude) {
  const auto named = [](double degrees) { return twilight_name(algebra::degrees(degrees)); };
  EXPECT_STREQ(named(-0.8), "day");
  EXPECT_STREQ(named(-0.9), "civil twilight");
  EXPECT_STREQ(named(-6.1), "nautical twilight");
  EXPECT_STREQ(named(-12.1), "astronomical twilight");
  EXPECT_STREQ(named(-18.1), "night");
  // U.S. Naval Observatory: the Sun set in London on 27 July 2018 at 20:55 BST
  auto london = almanac::city_named("London")->place;
  EXPECT_WITHIN(
      algebra::in_degrees(
          moment_at(london, {}, almanac::sky_at(almanac::instant_from_utc("2018-07-27T19:55Z")))
              .sun_altitude),
      -0.833, 0.3, "degrees: two minutes of the Sun's way, a minute and a city's size");
}

TEST(Circumstances, AreSummedUpInASentence) {
  EXPECT_EQ(what_is_seen(at("2018-07-27", "Nairobi")), "All of the eclipse is seen.");
  EXPECT_EQ(what_is_seen(at("2018-07-27", "Chicago")),
            "Nothing of the eclipse is seen: the Moon is below the horizon.");
  EXPECT_EQ(what_is_seen(at("2018-07-27", "London")),
            "The Moon rises 18 min after U2; some of totality is seen.");
}

almanac::Observer place(double latitude, double longitude) {
  return {algebra::degrees(latitude), algebra::degrees(longitude), {}};
}

TEST(Circumstances, OfAMoonUpBetweenContactsAreSeen) {
  const auto eclipse = eclipse_of("2018-07-27");
  const auto seen = [&](double latitude, double longitude) {
    return contacts_seen(circumstances(eclipse, place(latitude, longitude)));
  };
  // Between P1 and P4 the Moon comes up and goes down again over the Barents Sea, and goes down and comes up
  // again over the Antarctic coast
  EXPECT_EQ(seen(70.65, 35), "U3 to U4");
  EXPECT_EQ(seen(71, 35), "between U3 and U4");
  EXPECT_EQ(seen(-70.6, -124), "P1 to U1 and U4 to P4");
  EXPECT_EQ(contacts_seen(at("2018-07-27", "Nairobi")), "all");
  EXPECT_EQ(contacts_seen(at("2018-07-27", "London")), "greatest to P4");
  EXPECT_EQ(contacts_seen(at("2018-07-27", "Chicago")), "none");
  for (const auto& [latitude, longitude] : {std::pair(70.65, 35.), std::pair(-70.6, -124.)})
    EXPECT_SAYS(what_is_seen(circumstances(eclipse, place(latitude, longitude))), "The Moon ")
        << "the same rule as the almanac's";
}

TEST(Circumstances, OfAMoonThatGrazesTheHorizonAreFoundBetweenSteps) {
  const auto night = circumstances(eclipse_of("2018-07-27"), place(71.0562, 35));
  ASSERT_EQ(night.moments.size(), 9U)
      << "it comes up for some minutes, and is looked at each half hour";
  EXPECT_LT(almanac::seconds_between(moment(night, "moonrise").when, moment(night, "moonset").when),
            600);
}

TEST(LocalTime, KnowsSummerTimeAndTheDateLine) {
  const auto local = [](const char* utc, const char* zone) {
    const auto time = local_time(almanac::instant_from_utc(utc), zone);
    return time.date + " " + time.time + " " + time.abbreviation;
  };
  EXPECT_EQ(local("2018-03-25T00:59:59Z", "Europe/London"), "2018-03-25 00:59:59 GMT");
  EXPECT_EQ(local("2018-03-25T01:00:00Z", "Europe/London"), "2018-03-25 02:00:00 BST");
  EXPECT_EQ(local("2018-07-27T20:21:45Z", "Asia/Kolkata"), "2018-07-28 01:51:45 IST");
  EXPECT_EQ(local("2011-12-31T09:00:00Z", "Pacific/Apia"), "2011-12-31 23:00:00 +14");
  EXPECT_THROW(local("2018-07-27", "Moon/Tycho"), algebra::Error);
  EXPECT_THROW(local("2018-07-27", "../../etc/passwd"), algebra::Error);
  EXPECT_THROW(local("2018-07-27", "/usr/share/zoneinfo/UTC"), algebra::Error);
  EXPECT_THROW(local("2018-07-27", ""), algebra::Error);
  EXPECT_EQ(local("2018-07-27T20:21:45Z", "+05:30"), "2018-07-28 01:51:45 +0530");
}

TEST(LocalTime, GoesOnByTheZonesRuleAfterTheLastChangeThatIsListed) {
  const auto local = [](const char* utc, const char* zone) {
    const auto time = local_time(almanac::instant_from_utc(utc), zone);
    return time.date + " " + time.time + " " + time.abbreviation;
  };
  // summer in the north, winter in the south: lists of changes end in 2037
  EXPECT_EQ(local("2040-05-26T11:45:00Z", "America/Los_Angeles"), "2040-05-26 04:45:00 PDT");
  EXPECT_EQ(local("2040-05-26T11:45:00Z", "Australia/Sydney"), "2040-05-26 21:45:00 AEST");
  EXPECT_EQ(local("2040-11-18T19:00:00Z", "America/Los_Angeles"), "2040-11-18 11:00:00 PST");
  EXPECT_EQ(local("2040-11-18T19:00:00Z", "Australia/Sydney"), "2040-11-19 06:00:00 AEDT");
  EXPECT_EQ(local("2999-07-01T12:00:00Z", "Europe/London"), "2999-07-01 13:00:00 BST");
  EXPECT_EQ(almanac::utc_text(instant_of_local("2040-05-26T04:45:00", "America/Los_Angeles")),
            "2040-05-26T11:45:00Z");
}

TEST(LocalTime, BeforeZonesIsTheMeanTimeOfThePlace) {
  const auto local = [](const char* utc, const char* zone) {
    const auto time = local_time(almanac::instant_from_utc(utc), zone);
    return time.date + " " + time.time + " " + time.abbreviation;
  };
  // London's clocks were 75 s behind Greenwich until 1847, Los Angeles' 7 h 52 min 58 s until 1883
  EXPECT_EQ(local("1504-03-01T00:00:00Z", "Europe/London"), "1504-02-29 23:58:45 LMT");
  EXPECT_EQ(local("-0584-05-22T15:00:00Z", "Europe/London"), "-0584-05-22 14:58:45 LMT");
  EXPECT_EQ(local("0000-01-01T00:00:00Z", "America/Los_Angeles"), "-0001-12-31 16:07:02 LMT");
}

TEST(LocalTime, IsReadAsWell) {
  const auto utc = [](const char* local, const char* zone) {
    return almanac::utc_text(instant_of_local(local, zone));
  };
  EXPECT_EQ(utc("2018-07-28T01:51:45", "Asia/Kolkata"), "2018-07-27T20:21:45Z");
  EXPECT_EQ(utc("2018-03-25T00:59:59", "Europe/London"), "2018-03-25T00:59:59Z");
  EXPECT_EQ(utc("2018-03-25T02:00:00", "Europe/London"), "2018-03-25T01:00:00Z");
  EXPECT_EQ(utc("2018-10-28T01:30:00", "Europe/London"), "2018-10-28T00:30:00Z")
      << "the earlier of two";
  EXPECT_EQ(utc("2018-03-25T01:30:00", "Europe/London"), "2018-03-25T01:00:00Z")
      << "a time that no clock showed: when they leapt";
  EXPECT_THROW(utc("2018-07-27T20:21:45", "Moon/Tycho"), algebra::Error);
  EXPECT_THROW(utc("yesterday", "Europe/London"), algebra::Error);
}

const auto made_then = almanac::instant_from_utc("2018-07-01T12:00:00Z");

TEST(CalendarFile, IsOfLinesThatCalendarsRead) {
  const auto night = at("2018-07-27", "London");
  const auto text = as_calendar(night, "London, England", made_then);
  std::size_t begun = 0, ended = 0;
  for (std::size_t from = 0; from < text.size();) {
    const auto end = text.find("\r\n", from);
    ASSERT_NE(end, std::string::npos) << "RFC 5545: lines end in CRLF";
    const auto line = text.substr(from, end - from);
    EXPECT_LE(line.size(), 75U) << line;
    EXPECT_SAYS_NOT(line, '\n');
    begun += line == "BEGIN:VEVENT";
    ended += line == "END:VEVENT";
    from = end + 2;
  }
  EXPECT_EQ(begun, ended);
  EXPECT_EQ(begun, 5U) << "the eclipse; greatest, U3, U4 and P4, which are seen from there";
  EXPECT_SAYS(text, "DTSTART:20180727T202145Z");
  EXPECT_SAYS(text, "LOCATION:London\\, England");
  EXPECT_EQ(text, as_calendar(night, "London, England", made_then));
}

/// Values of all lines that begin with a name and a colon.
std::vector<std::string> values_of(const std::string& text, const std::string& name) {
  std::vector<std::string> values;
  for (std::size_t at = text.find("\n" + name + ":"); at != std::string::npos;
       at = text.find("\n" + name + ":", at + 1))
    values.push_back(text.substr(at + name.size() + 2, text.find('\r', at) - at - name.size() - 2));
  return values;
}

TEST(CalendarFile, HasAnEndForTheEclipseAloneAndNamesOfItsPlace) {
  const auto london = as_calendar(at("2018-07-27", "London"), "London", made_then),
             madrid = as_calendar(at("2018-07-27", "Madrid"), "Madrid", made_then);
  EXPECT_EQ(values_of(london, "DTEND").size(), 1U)
      << "RFC 5545, 3.8.2.2: an end is later than its start";
  for (const auto& stamp : values_of(london, "DTSTAMP")) EXPECT_EQ(stamp, "20180701T120000Z");
  auto names = values_of(london, "UID");
  const auto others = values_of(madrid, "UID");
  EXPECT_EQ(names.size(), 5U);
  EXPECT_FALSE(others.empty());
  names.insert(names.end(), others.begin(), others.end());
  EXPECT_EQ(std::set(names.begin(), names.end()).size(), names.size())
      << "a calendar takes the second event of one name for the first, changed";
}

/// Refusal of a calendar file, else the file.
template <class... Arguments>
std::string calendar_or_refusal(const Arguments&... arguments) {
  try {
    return as_calendar(arguments..., made_then);
  } catch (const algebra::Error& error) {
    return error.what();
  }
}

TEST(CalendarFile, BeginsWithMoonriseAndAnAlarmAnHourBefore) {
  auto sea_level = almanac::city_named("London")->place;
  sea_level.elevation = {};
  const auto text =
      as_calendar(circumstances(eclipse_of("2018-07-27"), sea_level), "London", made_then);
  EXPECT_TRUE(values_of(text, "DTSTART").front().starts_with("20180727T1949"))
      << "moonrise by the Naval Observatory's definition: 20:49 BST";
  EXPECT_EQ(values_of(text, "TRIGGER"), std::vector<std::string>{"-PT1H"});
  EXPECT_TRUE(values_of(as_calendar(at("2018-07-27", "Nairobi"), "Nairobi", made_then), "DTSTART")
                  .front()
                  .starts_with("20180727T1714"))
      << "P1, Espenak: 17:14:49";
  EXPECT_EQ(calendar_or_refusal(at("2018-07-27", "Chicago"), std::string("Chicago")),
            "Chicago sees nothing of the eclipse: no event for a calendar");
}

TEST(CalendarFile, OfSomeEclipsesHasAnEventEach) {
  const std::vector eclipses{eclipse_of("2018-01-31"), eclipse_of("2018-07-27")};
  const std::vector nights{at("2018-01-31", "London"), at("2018-07-27", "London")};
  const auto seen = calendar_or_refusal(nights, std::string("London"));
  const auto of_a_night = as_calendar(at("2018-07-27", "London"), "London", made_then);
  ASSERT_EQ(values_of(seen, "UID").size(), 1U) << "of January's London saw nothing";
  EXPECT_EQ(values_of(seen, "UID")[0], values_of(of_a_night, "UID")[0])
      << "a night's file replaces the event of the list";
  EXPECT_TRUE(values_of(seen, "DTEND")[0].starts_with("20180727T2328")) << "Espenak: 23:28:37";
  const auto nowhere = calendar_or_refusal(eclipses);
  EXPECT_EQ(values_of(nowhere, "UID")[1], "2018-07-27-eclipse@coppermoon");
  EXPECT_EQ(values_of(nowhere, "DESCRIPTION")[1],
            "Greatest at 20:21:45 UTC\\, umbral magnitude 1.61.");
  EXPECT_TRUE(values_of(nowhere, "LOCATION").empty());
  EXPECT_EQ(calendar_or_refusal(std::vector<eclipse::Eclipse>()),
            "no eclipse: a calendar has an event at least, allowed .csv or .json");
}

TEST(CalendarFile, HasNoYearsBeforeTheFirst) {
  auto ancient = eclipse_of("-0567-06-28");
  ancient.calendar = almanac::Calendar::julian;
  const auto night = circumstances(ancient, almanac::city_named("Baghdad")->place);
  EXPECT_EQ(calendar_or_refusal(night, std::string("Baghdad")),
            "eclipse of -0567-07-04: iCalendar has no years before 1, allowed .csv or .json");
  EXPECT_EQ(calendar_or_refusal(std::vector{night}, std::string("Baghdad")),
            calendar_or_refusal(night, std::string("Baghdad")));
  const auto contact = [&](const char* utc) {
    ancient.contacts.P1 = almanac::instant_from_utc(utc);
    return std::vector{ancient};
  };
  EXPECT_THROW(require_in_calendars(contact("0000-12-31T23:59:00Z")), algebra::Error);
  EXPECT_NO_THROW(require_in_calendars(contact("0001-01-01T00:01:00Z")));
}

}  // namespace coppermoon::uses::circumstances_test
