// SPDX-License-Identifier: MIT
#include "colour/picture_part.h"

#include "support/testing.h"

namespace coppermoon::colour::picture_part_test {

algebra::Grid<float> numbered(std::size_t rows, std::size_t columns) {
  algebra::Grid<float> picture(rows, columns);
  for (std::size_t i = 0; i < rows * columns; ++i) picture.values()[i] = static_cast<float>(i);
  return picture;
}

TEST(Reduced, IsTheMeanOfWholePixelsOfAPart) {
  const auto small = reduced(numbered(6, 10), {3, 1, 5, 5}, 2);
  ASSERT_EQ(small.rows(), 2u);
  ASSERT_EQ(small.columns(), 2u);
  EXPECT_EQ(small(0, 0), (13 + 14 + 23 + 24) / 4.F);
  EXPECT_EQ(small(1, 1), (35 + 36 + 45 + 46) / 4.F);
}

TEST(Reduced, ByOneIsThePartItself) {
  const auto part = reduced(numbered(6, 10), {3, 1, 5, 5}, 1);
  EXPECT_EQ(part(0, 0), 13);
  EXPECT_EQ(part(4, 4), 57);
}

TEST(WindowAbout, EndsWhereThePictureDoes) {
  const auto inside = window_about({50, 40, 10}, 100, 200),
             cut = window_about({5, 95, 10}, 100, 200);
  EXPECT_EQ(inside.left, 40u);
  EXPECT_EQ(inside.top, 30u);
  EXPECT_EQ(inside.columns, 20u);
  EXPECT_EQ(inside.rows, 20u);
  EXPECT_EQ(cut.left, 0u);
  EXPECT_EQ(cut.top, 85u);
  EXPECT_EQ(cut.columns, 15u);
  EXPECT_EQ(cut.rows, 15u);
}

}  // namespace coppermoon::colour::picture_part_test
