// SPDX-License-Identifier: MIT
#include "verbs/reports/in_words.h"

#include "support/testing.h"

namespace coppermoon::verbs::in_words_test {

TEST(InWords, ErrorsAreInPercent) {
  EXPECT_EQ(within(0.0029), "within 0.29 %");
  EXPECT_EQ(within(0.003), "within 0.3 %");
  EXPECT_EQ(within(5.6e-7), "within 0.001 %");
  EXPECT_EQ(within(0.25), "within 25 %");
  EXPECT_EQ(within(210), "in places wrong by more than the light itself");
}

TEST(InWords, NumbersHaveThreeDigitsAndNoExponent) {
  EXPECT_EQ(three_digits(5180.4), "5180");
  EXPECT_EQ(three_digits(99960), "100000");
  EXPECT_EQ(three_digits(999.6), "1000");
  EXPECT_EQ(three_digits(12.34), "12.3");
  EXPECT_EQ(three_digits(0.5), "0.5");
  EXPECT_EQ(three_digits(1.234e-5), "0.0000123");
  EXPECT_EQ(three_digits(0), "0");
}

TEST(InWords, DurationsAreInTheUnitThatPeopleWouldUse) {
  EXPECT_EQ(duration(0.014), "0.014 s");
  EXPECT_EQ(duration(1.23), "1.2 s");
  EXPECT_EQ(duration(42), "42 s");
  EXPECT_EQ(duration(840), "14 min");
  EXPECT_EQ(duration(3 * 3600.), "3 h");
  EXPECT_EQ(duration(4.2e5), "4.9 days");
  EXPECT_EQ(duration(4.2e7), "1.3 years");
  EXPECT_EQ(duration(4.2e10), "1300 years");
}

TEST(InWords, ExposuresAreAsCamerasShowThem) {
  EXPECT_EQ(exposure_in_words(1 / 3250.), "1/3200 s");
  EXPECT_EQ(exposure_in_words(1 / 3.), "1/3 s");
  EXPECT_EQ(exposure_in_words(0.5), "0.5 s");
  EXPECT_EQ(exposure_in_words(4), "4 s");
  EXPECT_EQ(exposure_in_words(100), "100 s");
  EXPECT_EQ(exposure_in_words(0), "0 s");
}

TEST(InWords, ACurveThatNoCameraHasIsDoubted) {
  colour::ToneCurve curve{{1, -3.9, 2}};
  EXPECT_EQ(doubt_of(curve), "");
  curve.numbers[1] = -19;
  EXPECT_SAYS(doubt_of(curve), "-19 standard deviations");
}

}  // namespace coppermoon::verbs::in_words_test
