// SPDX-License-Identifier: MIT
#include "algebra/number.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace coppermoon::algebra {
namespace {

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

}  // namespace
}  // namespace coppermoon::algebra
