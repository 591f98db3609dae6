// SPDX-License-Identifier: MIT
#include "eclipse/moment.h"

#include "support/testing.h"

namespace coppermoon::eclipse::moment_test {

/// Espenak & Meeus (2006): total, U2 at 19:30:15 UT.
Eclipse july_2018() {
  return *eclipse_of_day(almanac::instant_from_utc("2018-07-27"), ShadowConvention::danjon);
}

std::string refusal(const std::string& text, const Eclipse& eclipse) {
  return refusal_of([&] { moment_from(text, eclipse); });
}

TEST(Moment, OfAContactCountsFromIt) {
  const auto eclipse = july_2018();
  for (const auto& [text, published] :
       {std::pair{"U2", "2018-07-27T19:30:15Z"}, std::pair{"U2+10min", "2018-07-27T19:40:15Z"},
        std::pair{"u2+10min", "2018-07-27T19:40:15Z"},
        std::pair{"U2 + 10 min", "2018-07-27T19:40:15Z"},
        std::pair{"U2-0.5h", "2018-07-27T19:00:15Z"}})
    EXPECT_WITHIN(
        almanac::seconds_between(almanac::instant_from_utc(published), moment_from(text, eclipse)),
        0, 12, "s: what the contacts' published times are met by, at worst");
  EXPECT_EQ(almanac::seconds_between(eclipse.greatest, moment_from("Greatest", eclipse)), 0);
}

TEST(Moment, MayCountFromOthersThatHaveNames) {
  const auto eclipse = july_2018();
  const auto when = moment_from("Moonrise+1min", eclipse, {{"moonrise", eclipse.greatest}});
  EXPECT_WITHIN(almanac::seconds_between(eclipse.greatest, when), 60, 1e-4, "s: rounding of a day");
}

TEST(Moment, IsADayAClockTimeOrFromAContact) {
  for (const char* day : {"2018-07-27", "20180727", "-0584-05-22", "+2018-07-27"})
    EXPECT_TRUE(is_day(day)) << day;
  for (const char* none : {"2018-07-27T00:00", "2018072", "2018-7-27", ""})
    EXPECT_FALSE(is_day(none)) << none;
  for (const char* clock : {"2018-07-27 20:22", "2018-07-27T20:22:01.5", "20180727t2022"})
    EXPECT_TRUE(is_clock_time(clock)) << clock;
  for (const char* none : {"2018-07-27 20:22Z", "2018-07-27T20:22+02:00", "2018-07-27", "20:22",
                           "2018-07-27 U2+10min", "2018-07-27t20:22z"})
    EXPECT_FALSE(is_clock_time(none)) << none;
  EXPECT_FALSE(is_from_contact("2018-07-27 20:22"));
  EXPECT_TRUE(is_from_contact("2018-07-27 U2"));
  for (const char* word : {"U2+10min", "u2", "p1-3s", "Greatest", "moonrise+20min", "MOONSET"})
    EXPECT_TRUE(is_contact_or_time(word)) << word;
  for (const char* none : {"up.png", "moonrises.png", "moon.png", "-o"})
    EXPECT_FALSE(is_contact_or_time(none)) << none;
}

TEST(Moment, OfNothingIsRefusedWithWhatIsAllowed) {
  const auto eclipse = july_2018();
  EXPECT_SAYS(refusal("U5", eclipse), "P1, U1, U2, greatest");
  EXPECT_SAYS(refusal("U2+10weeks", eclipse), "as P1-10min");
  EXPECT_SAYS(refusal("U2+1000h", eclipse), "as P1-10min");
  const auto penumbral =
      *eclipse_of_day(almanac::instant_from_utc("2020-01-10"), ShadowConvention::danjon);
  EXPECT_SAYS(refusal("U1", penumbral), "P1, greatest, P4");
}

}  // namespace coppermoon::eclipse::moment_test
