// SPDX-License-Identifier: MIT
#include "algebra/number.h"

#include "support/testing.h"

namespace coppermoon::algebra::number_test {

TEST(NumberIn, IsWhatTheTextSpells) {
  EXPECT_EQ(number_in("1.5"), 1.5);
  EXPECT_EQ(number_in("-2e-3"), -2e-3);
  EXPECT_EQ(number_in("+20"), 20);
  EXPECT_EQ(number_in(".5"), 0.5);
  EXPECT_EQ(number_in("1E+3"), 1000);
}

TEST(NumberIn, IsNothingForAnyOtherText) {
  for (const char* text :
       {"", "+", "-", "+-1", "1 ", " 1", "1,5", "1e", "0x10", "one", "1.5s", "1e999"})
    EXPECT_EQ(number_in(text), std::nullopt) << "'" << text << "'";
}

TEST(NumberIn, LeavesInfinityAndNanToWhoKnowsTheRange) {
  EXPECT_EQ(number_in("-inf"), -std::numeric_limits<double>::infinity());
  ASSERT_TRUE(number_in("nan"));
  EXPECT_TRUE(std::isnan(*number_in("nan")));
}

TEST(NumberWithUnit, IsInTheUnitWhoseEndingItHas) {
  const std::vector<std::pair<std::string_view, double>> units{{"min", 60}, {"s", 1}, {"", 3600}};
  EXPECT_EQ(number_with_unit("1.5min", units), 90);
  EXPECT_EQ(number_with_unit("-2s", units), -2);
  EXPECT_EQ(number_with_unit("2", units), 7200);
  for (const char* text : {"", "min", "2 min", "2h"})
    EXPECT_EQ(number_with_unit(text, units), std::nullopt) << "'" << text << "'";
}

TEST(NumbersIn, AreThoseBetweenCommas) {
  EXPECT_EQ(numbers_in("1.5"), std::vector<double>{1.5});
  EXPECT_EQ(numbers_in("1.5,-2,3e2"), (std::vector<double>{1.5, -2, 300}));
  EXPECT_EQ(numbers_in(""), std::vector<double>{});
  for (const char* text : {",", "1,", ",1", "1,,2", "1, 2", "1;2"})
    EXPECT_EQ(numbers_in(text), std::nullopt) << "'" << text << "'";
}

}  // namespace coppermoon::algebra::number_test
