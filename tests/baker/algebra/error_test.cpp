// SPDX-License-Identifier: MIT
#include "support/testing.h"

namespace coppermoon::algebra::error_test {

TEST(RequireWithin, LetsTheEndsOfTheRangePass) {
  EXPECT_NO_THROW(require_within("x", 380, 380, 780));
  EXPECT_NO_THROW(require_within("x", 780, 380, 780));
}

TEST(RequireWithin, NamesTheValueItsUnitAndWhatIsAllowed) {
  EXPECT_EQ(refusal_of([] { require_within("wavelength [nm]", 100, 380, 780); }),
            "wavelength [nm] = 100, allowed 380 to 780");
}

TEST(RequireWithin, NeverHoldsANaNForInside) {
  EXPECT_THROW(require_within("x", std::numeric_limits<double>::quiet_NaN(), 0, 1), Error);
  EXPECT_THROW(require_within("x", std::numeric_limits<double>::infinity(), 0, 1), Error);
}

}  // namespace coppermoon::algebra::error_test
