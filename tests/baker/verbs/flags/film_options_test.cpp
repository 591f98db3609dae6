// SPDX-License-Identifier: MIT
#include "verbs/flags/film_options.h"
#include "algebra/error.h"
#include "request/recipe.h"
#include "support/testing.h"
#include "verbs/command_line.h"

namespace coppermoon::verbs::film_options_test {

using almanac::instant_from_utc;
using almanac::seconds_between;

/// U.S. Naval Observatory and EclipseWise: U1 18:24:27, U2 19:30:15, U3 21:13:12, U4 22:19:00 UT1.
constexpr const char* july_2018 = "2018-07-27";

uses::Moments moments_of(const FilmOptions& options) { return uses::moments_of(times_of(options)); }

std::string refusal(const FilmOptions& options) {
  return refusal_of([&] { moments_of(options); });
}

TEST(FilmOptions, GoFromContactToContact) {
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

TEST(FilmOptions, CountFromAContact) {
  const auto from = moments_of({.eclipse = july_2018, .from = "U2", .to = "U3", .frames = 2}),
             early = moments_of(
                 {.eclipse = july_2018, .from = "U2-10min", .to = "U3+1.5h", .frames = 2});
  EXPECT_WITHIN(seconds_between(early.frames[0], from.frames[0]), 600, 1e-4,
                "s: rounding of a day");
  EXPECT_WITHIN(seconds_between(from.frames[1], early.frames[1]), 5400, 1e-4,
                "s: rounding of a day");
}

TEST(FilmOptions, BeginAtMoonriseAndEndAtMoonset) {
  uses::ViewRequest view;
  const auto spans = [&](double north, double east) {
    view.observer = almanac::Observer{algebra::degrees(north), algebra::degrees(east), {}};
    const auto times = times_of({.eclipse = july_2018, .from = "moonrise", .to = "moonset"}, view);
    return std::pair(times.from, times.to);
  };
  const auto is_up = [&](const almanac::Instant& when, double later_s) {
    return moon_is_up(view, almanac::sky_at(almanac::later(when, later_s)));
  };
  const auto whole = times_of({.eclipse = july_2018});
  const auto [rise, end] = spans(42.3, 13.4);
  // some arcminutes of it are to be seen, and there the Moon rises 11 of them a minute
  EXPECT_TRUE(is_up(rise, 0) && !is_up(rise, -45));
  EXPECT_EQ(seconds_between(end, whole.to), 0) << "it is up at P4";
  const auto [begin, set] = spans(-35, 149);
  EXPECT_EQ(seconds_between(begin, whole.from), 0) << "it is up at P1";
  EXPECT_TRUE(is_up(set, 0) && !is_up(set, 45));
  EXPECT_EQ(refusal_of([&] { spans(40, -100); }).substr(0, 45),
            "the Moon is below the horizon of 40,-100 from");
  EXPECT_EQ(refusal_of([&] { times_of({.eclipse = july_2018, .from = "moonrise"}, {}); }),
            "moonrise and moonset are those of a place, and none is given");
}

/// What is said of the film's times, and what a recipe then holds of them.
struct Kept {
  uses::FilmTimes times;
  std::string said, from, to;
};

Kept kept_to_the_moon(FilmOptions options, double north, double east, bool asked = false) {
  uses::ViewRequest view;
  view.observer = almanac::Observer{algebra::degrees(north), algebra::degrees(east), {}};
  request::Parameters parameters;
  parameters.add(request::parameter("from", options.from, "first moment"));
  parameters.add(request::parameter("to", options.to, "last moment"));
  if (asked) parameters.find("from")->take({"P1"});
  Kept kept{times_of(options, view), {}, {}, {}};
  testing::internal::CaptureStderr();
  keep_to_the_moon(kept.times, parameters, view);
  kept.said = testing::internal::GetCapturedStderr();
  kept.from = parameters.find("from")->text();
  kept.to = parameters.find("to")->text();
  return kept;
}

TEST(FilmOptions, BeginAndEndWithTheMoonWhereNobodyAsksForMore) {
  const FilmOptions berlin{.eclipse = "2025-09-07"}, sydney{.eclipse = "2026-03-03"};
  // timeanddate.com: Berlin, moonrise at 17:37 UTC; Sydney is under the Moon at P1
  const auto rises = kept_to_the_moon(berlin, 52.52, 13.41);
  EXPECT_EQ(rises.said, "coppermoon: from moonrise, 17:37 UTC, to P4, 20:55 UTC\n");
  EXPECT_EQ(rises.from + rises.to, "moonriseP4");
  const auto again = times_of(
      {.eclipse = "2025-09-07", .from = "moonrise"},
      {.observer = almanac::Observer{algebra::degrees(52.52), algebra::degrees(13.41), {}}});
  EXPECT_EQ(seconds_between(rises.times.from, again.from), 0) << "as a recipe says it";
  const auto seen = kept_to_the_moon(sydney, -33.87, 151.21);
  EXPECT_EQ(seen.said, "");
  EXPECT_EQ(seen.from + seen.to, "P1P4") << "the recipe is as it was";
  EXPECT_EQ(kept_to_the_moon(sydney, 39.74, -104.98).to, "moonset") << "Denver";
  EXPECT_EQ(kept_to_the_moon(berlin, 52.52, 13.41, true).from, "P1") << "it was asked for";
  EXPECT_EQ(refusal_of([&] { kept_to_the_moon(berlin, 41.85, -87.65); }).substr(0, 52),
            "the Moon is below the horizon of 41.85,-87.65 from 2")
      << "Chicago";
  testing::internal::GetCapturedStderr();
}

TEST(FilmOptions, TakeALocalDayAndSayWhereAnotherIsTaken) {
  const almanac::Observer los_angeles{algebra::degrees(34.05), algebra::degrees(-118.24), {}};
  const auto said_of = [&](const char* day) {
    testing::internal::CaptureStderr();
    const auto eclipse = eclipse_of({.eclipse = day}, los_angeles);
    EXPECT_EQ(almanac::utc_text(eclipse.greatest).substr(0, 16), "2026-08-28T04:12") << day;
    return testing::internal::GetCapturedStderr();
  };
  EXPECT_EQ(said_of("2026-08-28"), "");
  EXPECT_EQ(said_of("2026-08-27"), "") << "in Los Angeles it is the evening of the 27th";
  EXPECT_EQ(said_of("2026-08-20").substr(0, 80),
            "coppermoon: no eclipse is greatest on 2026-08-20; the nearest, at 2026-08-28T04:");
}

TEST(FilmOptions, CountFromMoonriseAndReadLocalClocks) {
  const uses::ViewRequest view{
      .observer = almanac::Observer{algebra::degrees(52.52), algebra::degrees(13.41), {}}};
  const FilmOptions film{
      .eclipse = "2025-09-07", .from = "moonrise+5min", .to = "2025-09-07 22:00", .zone = "local"};
  const auto times = times_of(film, view);
  EXPECT_EQ(almanac::utc_text(times.to), "2025-09-07T20:00:00Z") << "two hours ahead in summer";
  EXPECT_TRUE(moon_is_up(view, almanac::sky_at(times.from)));
  EXPECT_FALSE(moon_is_up(view, almanac::sky_at(almanac::later(times.from, -310))));
  EXPECT_EQ(time_keys_from("moonrise+1min:1", times.eclipse, {view.observer}).size(), 1U);
}

TEST(FilmOptions, BetweenInstantsAreOfTheNearestEclipse) {
  const auto moments = moments_of({.from = "2018-07-27T19:00Z", .to = "U2"});
  EXPECT_EQ(almanac::utc_text(moments.eclipse.greatest).substr(0, 10), july_2018);
}

TEST(FilmOptions, OneFrameIsTheFirst) {
  const auto moments = moments_of({.eclipse = july_2018, .from = "greatest", .frames = 1});
  ASSERT_EQ(moments.frames.size(), 1U);
  EXPECT_EQ(almanac::utc_text(moments.frames[0]).substr(0, 16), "2018-07-27T20:21");
}

TEST(FilmOptions, ThatCannotBeAreSaid) {
  EXPECT_EQ(refusal({.from = "P1", .to = "P4"}),
            "from P1 to P4 of which eclipse? Name a day near it, as 2018-07-27");
  EXPECT_EQ(refusal({.eclipse = "2025-04-15"}).substr(0, 81),
            "no lunar eclipse within 15 days of 2025-04-15; the nearest is greatest at 2025-03")
      << "the full Moon before had one";
  EXPECT_EQ(refusal({.eclipse = "2019-07-16", .from = "U2"}),
            "moment = U2, allowed an instant or one of P1, U1, greatest, U4, P4 of the eclipse of "
            "2019-07-16, as P1-10min")
      << "a partial eclipse";
  for (const char* text : {"U9", "U2-", "U2-10", "U2+10days", "", "2018-13-01", "U2-10min-5s"})
    EXPECT_NE(refusal({.eclipse = july_2018, .from = text}), "") << text;
  EXPECT_NE(refusal({.eclipse = "tomorrow"}), "");
  EXPECT_EQ(refusal({.eclipse = july_2018, .from = "U3", .to = "U2"}),
            "--from U3 is later than --to U2");
  EXPECT_NE(refusal({.from = "2018-07-27", .to = "2018-08-27"}), "") << "a month";
  EXPECT_NE(refusal({.eclipse = july_2018, .frames = 0}), "");
  EXPECT_NE(refusal({.eclipse = july_2018, .frames = 9, .time_scale = 60}), "") << "both";
  EXPECT_NE(refusal({.eclipse = july_2018, .fps = {0}}), "");
}

TEST(FilmOptions, OfAMountSayWhatTheyLack) {
  const FilmOptions fixed{.mount = uses::Mount::fixed}, aimed{.aim = "30,120"},
      both{.mount = uses::Mount::fixed, .aim = "30,120"};
  EXPECT_EQ(refusal_of([&] { mounting_of(fixed, false); }), "mount = fixed: needs --at");
  EXPECT_EQ(refusal_of([&] { mounting_of(aimed, true); }),
            "mount = tracking: --aim needs a fixed one");
  EXPECT_FALSE(mounting_of(fixed, true).aim);
  const auto mounting = mounting_of(both, true);
  ASSERT_TRUE(mounting.aim);
  EXPECT_WITHIN(algebra::in_degrees(mounting.aim->azimuth), 120, 1e-12, "degrees: rounding");
}

TEST(ExposureKeys, AreMomentsAndSecondsInOrder) {
  const auto eclipse = times_of({.eclipse = july_2018}).eclipse;
  EXPECT_TRUE(time_keys_from("follow", eclipse).empty());
  const auto keys = time_keys_from("U1:0.01,2018-07-27T19:30:00Z:2", eclipse);
  ASSERT_EQ(keys.size(), 2U);
  EXPECT_EQ(keys[0].second, 0.01);
  EXPECT_EQ(almanac::utc_text(keys[1].first), "2018-07-27T19:30:00Z");
  EXPECT_EQ(refusal_of([&] { time_keys_from("U1:0.01,U1:2", eclipse); }),
            "exposure time = U1:0.01,U1:2, allowed keys in order of time");
  EXPECT_EQ(refusal_of([&] { time_keys_from("U1:0.01,U2", eclipse); }),
            "exposure time = U1:0.01,U2, allowed keys as P1:1/1000,U2:4: a moment and seconds");
}

TEST(FilesOfAFilm, AddWhatTheyAreMadeOf) {
  EXPECT_EQ(make_text(products_of({.files = {.composite = "a.png"}})), "frames,pictures");
  EXPECT_EQ(make_text(products_of({.files = {.stage = "a.usda"}})), "textures,pictures");
  EXPECT_EQ(make_text(products_of({.make = "textures", .files = {.stage = "a.usda"}})), "textures");
  EXPECT_EQ(make_text(products_of({.make = "scenes", .files = {.contact_sheet = "a.png"}})),
            "scenes,pictures");
  EXPECT_EQ(make_text(products_of({.make = "tx", .files = {.movie = "a.mov"}})), "tx,pictures");
  EXPECT_EQ(make_text(products_of({.make = "light"})), "light");
}

TEST(FilesOfAFilm, AreOfKnownEndingsAndOfAWholeFilm) {
  EXPECT_EQ(refusal_of([] { require_whole_film({.files = {.movie = "a.avi"}}); }),
            "a.avi: a movie ends in .mp4 or .mov");
  EXPECT_EQ(refusal_of([] { require_whole_film({.files = {.movie = "a.mov"}}); }), "");
  EXPECT_EQ(refusal_of([] { require_whole_film({.files = {.composite = "a.png"}}); }), "");
  EXPECT_EQ(
      refusal_of([] { require_whole_film({.shard = "1/2", .files = {.composite = "a.png"}}); }),
      "--composite needs every frame: run it without --shard after all shards, which are "
      "made with --make frames,pictures");
}

/// What a command line says of a film, and the recipe's line of one of its flags.
struct Said {
  FilmOptions options;
  std::string line;
};

Said said(const std::string& flag, const std::string& text) {
  Said all;
  Verb verb;
  add_film_options(verb, all.options);
  take(verb, {"--" + flag + "=" + text});
  all.line = text_of(request::recipe_of(
      verb.parameters, [&](const auto& parameter) { return parameter.name == flag; }));
  return all;
}

TEST(FilmOptions, OfOneRateAndDurationAreOneRecipe) {
  EXPECT_EQ(said("fps", "24").line, "fps = 24\n") << "as before";
  for (const char* text : {"23.976", "24000/1001"}) {
    const auto [options, line] = said("fps", text);
    EXPECT_EQ(options.fps.frames, 24000);
    EXPECT_EQ(options.fps.seconds, 1001);
    EXPECT_EQ(line, "fps = '24000/1001'\n");
  }
  for (const char* text : {"120", "120s", "2min"}) {
    const auto [options, line] = said("duration", text);
    EXPECT_EQ(options.duration_s, 120);
    EXPECT_EQ(line, "duration = 120\n") << text;
  }
  EXPECT_EQ(refusal_of([] { said("duration", "10x"); }),
            "duration = 10x, allowed 0.001 to 1e6 s, as 10, 10s or 2min");
  const auto numbered = said("start-frame", "1001");
  EXPECT_EQ(numbered.line, "start-frame = 1001\n");
  auto film = numbered.options;
  film.eclipse = july_2018;
  EXPECT_EQ(moments_of(film).first_frame, 1001U);
}

TEST(Products, AreReadWithCommasBetween) {
  const auto products = products_of({.make = "scenes,pictures", .hdr = true});
  EXPECT_TRUE(products.scenes && products.textures && products.pictures);
  EXPECT_FALSE(products.frames || products.light_alone());
  EXPECT_TRUE(products_of({.make = "light"}).light_alone());
  EXPECT_THROW(products_of({.make = "films"}), algebra::Error);
  EXPECT_TRUE(products.high_range);
  EXPECT_THROW(products_of({.make = "frames", .hdr = true}), algebra::Error);
}

}  // namespace coppermoon::verbs::film_options_test
