// SPDX-License-Identifier: MIT
#include "algebra/grid.h"

#include "support/testing.h"

namespace coppermoon::algebra::grid_test {

TEST(Grid, KeepsItsValuesRowByRow) {
  Grid<int> grid(2, 3, 7);
  grid(0, 2) = 1;
  grid(1, 0) = 2;
  const auto values = grid.values();
  EXPECT_EQ(std::vector<int>(values.begin(), values.end()), (std::vector<int>{7, 7, 1, 2, 7, 7}));
}

TEST(Grid, LendsOutItsRows) {
  Grid<int> grid(3, 2);
  std::ranges::fill(grid.row(1), 5);
  EXPECT_EQ(grid.row(1).size(), 2u);
  EXPECT_EQ(grid(0, 1), 0);
  EXPECT_EQ(grid(1, 0), 5);
  EXPECT_EQ(grid(1, 1), 5);
  EXPECT_EQ(grid(2, 0), 0);
}

TEST(Grid, IsEmptyWhenNotGivenASize) {
  EXPECT_TRUE(Grid<int>().empty());
  EXPECT_FALSE(Grid<int>(1, 1).empty());
  EXPECT_EQ(Grid<int>(4, 9).rows(), 4u);
  EXPECT_EQ(Grid<int>(4, 9).columns(), 9u);
}

}  // namespace coppermoon::algebra::grid_test
