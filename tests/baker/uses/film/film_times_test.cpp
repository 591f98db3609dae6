// SPDX-License-Identifier: MIT
#include "uses/film/film_times.h"
#include "support/testing.h"

namespace coppermoon::uses::film_times_test {

using almanac::instant_from_utc;
using almanac::seconds_between;

/// U.S. Naval Observatory and EclipseWise: U1 18:24:27, U2 19:30:15, U3 21:13:12, U4 22:19:00 UT1.
const eclipse::Eclipse& july_2018() {
  static const auto eclipse =
      eclipse::nearest_eclipse(instant_from_utc("2018-07-27"), eclipse::ShadowConvention::danjon);
  return eclipse;
}

FilmTimes times(const char* from, const char* to) {
  return {.eclipse = july_2018(), .from = instant_from_utc(from), .to = instant_from_utc(to)};
}

FilmTimes an_hour() { return times("2018-07-27T19:00Z", "2018-07-27T20:00Z"); }

std::string refusal_of(const FilmTimes& times) {
  return coppermoon::refusal_of([&] { moments_of(times); });
}

TEST(FilmTimes, AreEvenFromTheFirstMomentToTheLast) {
  auto all = an_hour();
  all.frames = 3;
  const auto moments = moments_of(all);
  ASSERT_EQ(moments.frames.size(), 3U);
  EXPECT_WITHIN(seconds_between(all.from, moments.frames[0]), 0, 1e-4, "s: rounding of a day");
  EXPECT_WITHIN(seconds_between(all.from, moments.frames[1]), 1800, 1e-4, "s: rounding of a day");
  EXPECT_WITHIN(seconds_between(all.to, moments.frames[2]), 0, 1e-4, "s: rounding of a day");
  EXPECT_EQ(almanac::utc_text(moments.eclipse.greatest), almanac::utc_text(july_2018().greatest));
}

TEST(FilmTimes, OfATimeScaleAreFramesOfTheFilm) {
  // an hour of the eclipse, 600 s of it to a second of the film: 6 s of film
  auto all = an_hour();
  all.fps = {25}, all.time_scale = 600;
  const auto moments = moments_of(all);
  ASSERT_EQ(moments.frames.size(), 6U * 25 + 1);
  EXPECT_WITHIN(seconds_between(moments.frames[0], moments.frames[1]), 24, 1e-4,
                "s: rounding of a day");
}

TEST(FilmTimes, AreOf240FramesUnlessSaidOtherwise) {
  EXPECT_EQ(moments_of(an_hour()).frames.size(), 240U);
}

TEST(FilmTimes, OneFrameIsTheFirst) {
  auto all = an_hour();
  all.frames = 1;
  const auto moments = moments_of(all);
  ASSERT_EQ(moments.frames.size(), 1U);
  EXPECT_EQ(almanac::utc_text(moments.frames[0]), "2018-07-27T19:00:00Z");
}

TEST(FilmTimes, OfADurationAreAsManyFramesAsItHas) {
  auto all = an_hour();
  all.duration_s = 10, all.fps = {25};
  const auto moments = moments_of(all);
  ASSERT_EQ(moments.frames.size(), 250U);
  EXPECT_EQ(almanac::utc_text(moments.frames.back()), "2018-07-27T20:00:00Z");
  all.duration_s = 0.001;
  EXPECT_EQ(moments_of(all).frames.size(), 1U);
  all.duration_s = 10, all.fps = {24000, 1001};
  EXPECT_EQ(moments_of(all).frames.size(), 240U) << "239.76 rounded";
  all.frames = 240;
  EXPECT_EQ(moments_of(all).frames.size(), 240U) << "both agree";
}

TEST(FilmTimes, NumberTheirFramesFromTheFirstOn) {
  auto all = an_hour();
  all.frames = 3, all.first_frame = 1001;
  const auto moments = moments_of(all);
  EXPECT_EQ(moments.last_frame(), 1003U);
  EXPECT_EQ(almanac::utc_text(moments.at(1001)), "2018-07-27T19:00:00Z");
  EXPECT_EQ(almanac::utc_text(moments.at(1003)), "2018-07-27T20:00:00Z");
}

TEST(FilmTimes, MayBeAHandfulOfMoments) {
  auto some = an_hour();
  some.moments = {almanac::later(some.from, 60), almanac::later(some.from, 9000)};
  const auto moments = moments_of(some);
  ASSERT_EQ(moments.frames.size(), 2U);
  EXPECT_EQ(almanac::utc_text(moments.frames[0]), "2018-07-27T19:01:00Z");
  EXPECT_EQ(almanac::utc_text(moments.frames[1]), "2018-07-27T21:30:00Z");
}

TEST(FilmTimes, ThatCannotBeAreSaid) {
  const auto refused = [](auto change) {
    auto times = an_hour();
    change(times);
    return refusal_of(times);
  };
  EXPECT_EQ(refusal_of(times("2018-07-27T20:00Z", "2018-07-27T19:00Z")),
            "from 2018-07-27T20:00:00Z to 2018-07-27T19:00:00Z are -3600 s, allowed 0 to 86400");
  EXPECT_NE(refusal_of(times("2018-07-27", "2018-08-27")), "") << "a month";
  EXPECT_EQ(refused([](auto& t) { t.frames = 0; }), "frames = 0, allowed 1 to 1e+06");
  EXPECT_EQ(refused([](auto& t) { t.frames = 9, t.time_scale = 60; }),
            "frames = 9 and time-scale = 60, allowed one of the two");
  EXPECT_EQ(refused([](auto& t) { t.duration_s = 9, t.time_scale = 60; }),
            "time-scale = 60 and duration = 9, allowed one of the two");
  EXPECT_EQ(refused([](auto& t) { t.moments = {t.from}, t.frames = 1; }),
            "1 moments and frames = 1, allowed one of the two");
  EXPECT_EQ(refused([](auto& t) {
              t.moments = {t.to, t.from};
            }),
            "moments = 2018-07-27T19:00:00Z after 2018-07-27T20:00:00Z, allowed in order of time");
  EXPECT_EQ(refused([](auto& t) { t.duration_s = 0; }), "duration [s] = 0, allowed 0.001 to 1e+06");
  EXPECT_EQ(refused([](auto& t) { t.time_scale = 0; }), "time scale = 0, allowed 0.001 to 1e+06");
  EXPECT_EQ(refused([](auto& t) { t.fps = {0}; }), "fps = 0, allowed 1 to 1000");
  EXPECT_EQ(refused([](auto& t) { t.duration_s = 10, t.frames = 100; }),
            "frames = 100 and duration = 10 s, allowed one of the two, or the 240 frames that 10 s "
            "have at 24 frames per second");
  EXPECT_EQ(refused([](auto& t) { t.first_frame = 2000000; }),
            "first frame = 2e+06, allowed 0 to 1e+06");
}

}  // namespace coppermoon::uses::film_times_test
