// SPDX-License-Identifier: MIT
#include "verbs/flags/moments.h"
#include "algebra/error.h"
#include "support/testing.h"
#include "verbs/command_line.h"

namespace coppermoon::verbs::moments_test {

using Words = std::vector<std::string>;

std::string text_of(const MomentOptions& options) { return almanac::utc_text(instant_of(options)); }

std::string refusal(const MomentOptions& options) {
  return refusal_of([&] { instant_of(options); });
}

double seconds_from(const char* published, const MomentOptions& options) {
  return almanac::seconds_between(almanac::instant_from_utc(published), instant_of(options));
}

TEST(Moments, OfADayAloneAreItsGreatestEclipse) {
  // Espenak & Meeus (2006): 2018 Jul 27, greatest at 20:22:54 TD, ΔT 71 s, to the second
  EXPECT_WITHIN(seconds_from("2018-07-27T20:21:44Z", {"2018-07-27"}), 0, 12,
                "s: what published contacts are met by, at worst");
}

TEST(Moments, OfADayAndAContactCountFromIt) {
  const char* worst = "s: what the contacts' published times are met by, at worst";
  EXPECT_WITHIN(seconds_from("2018-07-27T19:30:15Z", {"2018-07-27 U2"}), 0, 12, worst);
  EXPECT_WITHIN(seconds_from("2018-07-27T19:40:15Z", {"2018-07-27 U2+10min"}), 0, 12, worst);
  EXPECT_WITHIN(seconds_from("2018-07-27T20:20:14Z", {"2018-07-27 greatest-90s"}), 0, 12, worst);
}

TEST(Moments, AreToTheFullSecondThatIsSaid) {
  for (const char* text : {"2018-07-27", "2018-07-27 U2"}) {
    testing::internal::CaptureStderr();
    const auto when = text_of({text});
    const auto said = testing::internal::GetCapturedStderr();
    EXPECT_SAYS(said, "2018-07-27 " + when.substr(11, 8) + " UTC\n");
    EXPECT_EQ(almanac::seconds_between(almanac::instant_from_utc(when), instant_of({text})), 0);
  }
}

TEST(Moments, OfALocalDayAreSaidWithTheirOwnDate) {
  const almanac::Observer los_angeles{algebra::degrees(34.05), algebra::degrees(-118.24), {}};
  testing::internal::CaptureStderr();
  instant_of({"2026-08-27"}, los_angeles);
  const auto said = testing::internal::GetCapturedStderr();
  EXPECT_TRUE(
      said.starts_with("coppermoon: the greatest eclipse of 2026-08-27 is 2026-08-28 04:12"))
      << said;
}

TEST(Moments, OfATimeOfDayAreThatTimeAndNothingIsSaid) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(text_of({"2018-07-27 20:22"}), "2018-07-27T20:22:00Z");
  EXPECT_EQ(text_of({"2018-07-28T00:22:00+04:00"}), "2018-07-27T20:22:00Z");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Moments, OfAJulianDayAreThatDays) {
  // the Peterborough Chronicle's eclipse of 5 May 1110
  EXPECT_EQ(text_of({"1110-05-05", almanac::Calendar::julian}).substr(0, 10), "1110-05-12");
  EXPECT_NE(refusal({"1110-05-05"}), "");
}

TEST(Moments, OfAJulianDayAreSaidInItsCalendar) {
  testing::internal::CaptureStderr();
  instant_of({"1110-05-05", almanac::Calendar::julian});
  const auto said = testing::internal::GetCapturedStderr();
  EXPECT_TRUE(said.starts_with("coppermoon: the greatest eclipse of 1110-05-05 is 1110-05-05 "))
      << said;
}

TEST(Moments, WithAPlaceAndNoOffsetAreSaidToBeUtc) {
  const auto said = [](const Words& words) {
    Verb verb;
    MomentOptions options;
    std::string at;
    add_moment_options(verb, options);
    add_flag(verb, "--at", at, "");
    take(verb, words);
    testing::internal::CaptureStderr();
    say_what_is_utc(verb);
    return testing::internal::GetCapturedStderr();
  };
  EXPECT_EQ(
      said({"2018-07-27 20:22", "--at", "London"}),
      "coppermoon: 2018-07-27 20:22 is read as UTC; --zone local, or an offset, as 2018-07-27 "
      "20:22+02:00, says otherwise\n");
  EXPECT_NE(said({"2018-07-27T20:22:01.5", "--at", "London"}), "");
  for (const char* clear :
       {"2018-07-27 20:22Z", "2018-07-27T20:22:00-04:00", "2018-07-27", "2018-07-27 U2+10min"})
    EXPECT_EQ(said({clear, "--at", "London"}), "") << clear;
  EXPECT_EQ(said({"2018-07-27 20:22", "--at", "London", "--zone", "local"}), "");
  EXPECT_EQ(said({"2018-07-27 20:22"}), "") << "without a place nobody expects its clocks";
}

TEST(Places, OfSeveralCitiesAreSaidToBeTheLargest) {
  const auto said = [](const std::string& place) {
    Verb verb;
    std::string at;
    add_flag(verb, "--at", at, "");
    take(verb, {"--at", place});
    testing::internal::CaptureStderr();
    say_which_city(verb);
    return testing::internal::GetCapturedStderr();
  };
  EXPECT_TRUE(said("Springfield")
                  .starts_with("coppermoon: Springfield is Springfield/Missouri; others are "));
  EXPECT_EQ(said("Springfield/Illinois"), "");
}

TEST(Moments, OfADayWithoutAnEclipseAreRefusedWithTheNearest) {
  const auto said = refusal({"2018-07-28"});
  EXPECT_SAYS(said, "the nearest is at 2018-07-27T20:2");
  EXPECT_SAYS(refusal({"2018-07-27 U5"}), "allowed");
  // penumbral alone: it has no U1
  EXPECT_SAYS(refusal({"2020-01-10 U1"}), "P1, greatest, P4");
}

TEST(Moments, InTwoArgumentsAreOne) {
  const auto given = [](const Words& words) {
    Verb verb;
    MomentOptions options;
    std::string output;
    add_moment_options(verb, options);
    add_flag(verb, "-o,--output", output, "");
    take(verb, words);
    return options.text;
  };
  EXPECT_EQ(given({"2018-07-27", "U2+10min", "-o", "a.png"}), "2018-07-27 U2+10min");
  EXPECT_EQ(given({"--instant", "2018-07-27", "20:22"}), "2018-07-27 20:22");
  EXPECT_EQ(given({"2025-09-07", "moonrise+20min"}), "2025-09-07 moonrise+20min");
  EXPECT_THROW(given({"2018-07-27", "-o", "U2.png", "U2"}), WrongUsage) << "not side by side";
  EXPECT_THROW(given({"2018-07-27T20:22Z", "20:22"}), WrongUsage) << "no day";
}

}  // namespace coppermoon::verbs::moments_test
