// SPDX-License-Identifier: MIT
#include "shadow/landed_rows.h"

#include "support/testing.h"

namespace coppermoon::shadow::landed_rows_test {

TEST(TurnIntoCosines, AgreesWithTheStandardLibrary) {
  std::vector<double> angles;
  for (int i = -2000; i < 2000; ++i) angles.push_back(0.0157 * i);
  ASSERT_EQ(angles.size() % nodes_together, 0);
  auto cosines = angles;
  turn_into_cosines(cosines);
  for (std::size_t i = 0; i < angles.size(); ++i)
    EXPECT_WITHIN(cosines[i], std::cos(angles[i]), 1e-15,
                  "Highway's: three units of the last place")
        << angles[i];
}

}  // namespace coppermoon::shadow::landed_rows_test
