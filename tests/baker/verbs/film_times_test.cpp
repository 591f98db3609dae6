// SPDX-License-Identifier: MIT
#include "verbs/film_times.h"

#include <string>

#include "algebra/error.h"
#include "support/within.h"

namespace coppermoon::verbs {
namespace {

using almanac::instant_from_utc;
using almanac::seconds_between;

/// U.S. Naval Observatory and EclipseWise: U1 18:24:27, U2 19:30:15, U3 21:13:12, U4 22:19:00 UT1.
constexpr const char* july_2018 = "2018-07-27";

std::string message_of(const FilmTimes& options) {
  try {
    moments_of(options);
  } catch (const algebra::Error& error) {
    return error.what();
  }
  return "";
}

TEST(FilmTimes, GoFromContactToContact) {
  const auto moments = moments_of({.eclipse = july_2018, .from = "U1", .to = "U4", .frames = 3});
  ASSERT_EQ(moments.frames.size(), 3U);
  EXPECT_WITHIN(seconds_between(instant_from_utc("2018-07-27T18:24:27Z"), moments.frames[0]), 0, 12,
                "s: what the contacts' published times are met by, at worst");
  EXPECT_WITHIN(seconds_between(instant_from_utc("2018-07-27T22:19:00Z"), moments.frames[2]), 0, 12,
                "s: the same");
  EXPECT_WITHIN(seconds_between(moments.frames[0], moments.frames[1]),
                seconds_between(moments.frames[1], moments.frames[2]), 1e-4,
                "s: rounding of a day");
}

TEST(FilmTimes, CountFromAContact) {
  const auto from = moments_of({.eclipse = july_2018, .from = "U2", .to = "U3", .frames = 2}),
             early = moments_of(
                 {.eclipse = july_2018, .from = "U2-10min", .to = "U3+1.5h", .frames = 2});
  EXPECT_WITHIN(seconds_between(early.frames[0], from.frames[0]), 600, 1e-4,
                "s: rounding of a day");
  EXPECT_WITHIN(seconds_between(from.frames[1], early.frames[1]), 5400, 1e-4,
                "s: rounding of a day");
}

TEST(FilmTimes, OfATimeScaleAreFramesOfTheFilm) {
  // an hour of the eclipse, 600 s of it to a second of the film: 6 s of film
  const auto moments = moments_of(
      {.from = "2018-07-27T19:00Z", .to = "2018-07-27T20:00Z", .fps = 25, .time_scale = 600});
  ASSERT_EQ(moments.frames.size(), 6U * 25 + 1);
  EXPECT_WITHIN(seconds_between(moments.frames[0], moments.frames[1]), 24, 1e-4,
                "s: rounding of a day");
}

TEST(FilmTimes, BetweenInstantsAreOfTheNearestEclipse) {
  const auto moments = moments_of({.from = "2018-07-27T19:00Z", .to = "U2"});
  EXPECT_EQ(almanac::utc_text(moments.eclipse.greatest).substr(0, 10), july_2018);
  EXPECT_EQ(moments.frames.size(), 240U) << "unless said otherwise";
}

TEST(FilmTimes, OneFrameIsTheFirst) {
  const auto moments = moments_of({.eclipse = july_2018, .from = "greatest", .frames = 1});
  ASSERT_EQ(moments.frames.size(), 1U);
  EXPECT_EQ(almanac::utc_text(moments.frames[0]).substr(0, 16), "2018-07-27T20:21");
}

TEST(FilmTimes, ThatCannotBeAreSaid) {
  EXPECT_EQ(message_of({.from = "P1", .to = "P4"}),
            "from P1 to P4 of which eclipse? Name a day near it, as 2018-07-27");
  EXPECT_EQ(message_of({.eclipse = "2025-04-15"}).substr(0, 81),
            "no lunar eclipse within 15 days of 2025-04-15; the nearest is greatest at 2025-03")
      << "the full Moon before had one";
  EXPECT_EQ(message_of({.eclipse = "2019-07-16", .from = "U2"}),
            "moment = U2, allowed an instant or one of P1, U1, greatest, U4, P4 of the eclipse of "
            "2019-07-16, as P1-10min")
      << "a partial eclipse";
  for (const char* text : {"U9", "U2-", "U2-10", "U2+10days", "", "2018-13-01", "U2-10min-5s"})
    EXPECT_NE(message_of({.eclipse = july_2018, .from = text}), "") << text;
  EXPECT_NE(message_of({.eclipse = "tomorrow"}), "");
  EXPECT_NE(message_of({.eclipse = july_2018, .from = "U3", .to = "U2"}), "") << "backwards";
  EXPECT_NE(message_of({.from = "2018-07-27", .to = "2018-08-27"}), "") << "a month";
  EXPECT_NE(message_of({.eclipse = july_2018, .frames = 0}), "");
  EXPECT_NE(message_of({.eclipse = july_2018, .frames = 9, .time_scale = 60}), "") << "both";
  EXPECT_NE(message_of({.eclipse = july_2018, .time_scale = 0}), "");
  EXPECT_NE(message_of({.eclipse = july_2018, .fps = 0}), "");
}

TEST(Contacts, OfATotalEclipseAreSevenInOrder) {
  const auto all = contacts_of(moments_of({.eclipse = july_2018}).eclipse);
  ASSERT_EQ(all.size(), 7U);
  for (std::size_t i = 1; i < all.size(); ++i)
    EXPECT_GT(seconds_between(all[i - 1].second, all[i].second), 0) << all[i].first;
}

}  // namespace
}  // namespace coppermoon::verbs
