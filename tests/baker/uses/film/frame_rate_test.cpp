// SPDX-License-Identifier: MIT
#include "algebra/error.h"
#include "support/testing.h"
#include "uses/film/film_times.h"

namespace coppermoon::uses::frame_rate_test {

std::string refusal(const char* text) {
  return refusal_of([&] { frame_rate_from(text); });
}

TEST(FrameRates, OfTelevisionAreRatiosHoweverTheyAreWritten) {
  for (const auto& [text, ratio] : {std::pair("23.976", "24000/1001"),
                                    {"23.98", "24000/1001"},
                                    {"23.976024", "24000/1001"},
                                    {"24000/1001", "24000/1001"},
                                    {"29.97", "30000/1001"},
                                    {"47.952", "48000/1001"},
                                    {"59.94", "60000/1001"},
                                    {"119.88", "120000/1001"}})
    EXPECT_EQ(text_of(frame_rate_from(text)), ratio) << text;
}

TEST(FrameRates, OfOtherNumbersAreThoseNumbers) {
  for (const auto& [text, same] : {std::pair("24", "24"),
                                   {"25.0", "25"},
                                   {"12.5", "12.5"},
                                   {"50/4", "12.5"},
                                   {"23.9", "23.9"},
                                   {"1000", "1000"},
                                   {"24.99951", "25"},
                                   {"10/3", "10/3"}})
    EXPECT_EQ(text_of(frame_rate_from(text)), same) << text;
  EXPECT_EQ(frame_rate_from("12.5").frames, 25);
  EXPECT_EQ(frame_rate_from("12.5").seconds, 2);
}

TEST(FrameRates, ThatCannotBeAreSaid) {
  EXPECT_EQ(refusal("0"), "fps = 0, allowed 1 to 1000");
  EXPECT_EQ(refusal("film"), "fps = film, allowed 1 to 1000, as 24, 23.976 or 24000/1001");
  for (const char* text :
       {"24000/0", "24000/-1001", "1/2", "2001/2", "24/", "/1", "2.5/1", "24/20000"})
    EXPECT_EQ(refusal(text), std::string("fps = ") + text +
                                 ", allowed 1 to 1000, a ratio of whole numbers with 1 to 10000 "
                                 "below");
}

}  // namespace coppermoon::uses::frame_rate_test
