// SPDX-License-Identifier: MIT
#include "uses/picture/disc_outline.h"

#include "povray_scenes/scene_camera.h"
#include "support/testing.h"

namespace coppermoon::uses::disc_outline_test {

/// A camera 220 lunar radii away, off the Moon's middle, its Moon flattened.
povray_scenes::SceneCamera camera(double field_deg, double flattening = 0.9) {
  return {.position = {219, 14, -9},
          .up = {0, 0.3, 1},
          .horizontal_field = algebra::degrees(field_deg),
          .width = 90,
          .height = 60,
          .flattening = flattening,
          .zenith = {0, 1, 1},
          .direction = {-219, -13.7, 9.1}};
}

TEST(DiscOutline, IsWhereSightsMeetTheMoon) {
  for (const double field : {0.6, 3.}) {
    const auto camera_there = camera(field);
    const auto sight = povray_scenes::sight_of(camera_there);
    const auto outline = disc_outline(camera_there);
    ASSERT_TRUE(outline);
    for (double y = 0.5; y < 60; ++y)
      for (double x = 0.5; x < 90; ++x) {
        const double share = covered_share(*outline, x, y);
        const bool seen = povray_scenes::ground_at(sight, {x, y}).has_value();
        if (std::abs(share - 0.5) > 0.01) {
          EXPECT_EQ(share > 0.5, seen) << x << ", " << y;
        }
      }
  }
}

TEST(DiscOutline, CoversPixelsAsMuchAsManySightsThroughThemSay) {
  const auto camera_there = camera(0.6);
  const auto sight = povray_scenes::sight_of(camera_there);
  const auto outline = *disc_outline(camera_there);
  constexpr int fine = 20;
  int edges = 0;
  for (int row = 0; row < 60; ++row)
    for (int column = 0; column < 90; ++column) {
      const double share = covered_share(outline, column + 0.5, row + 0.5);
      if (share == 0 || share == 1) continue;
      int seen = 0;
      for (int i = 0; i < fine * fine; ++i)
        seen += povray_scenes::ground_at(
                    sight, {column + (i % fine + 0.5) / fine, row + (i / fine + 0.5) / fine})
                    .has_value();
      EXPECT_WITHIN(share, seen / double{fine * fine}, 0.03,
                    "the edge is straight in a pixel to 1/250 of it; 20 sights a side");
      ++edges;
    }
  EXPECT_GT(edges, 100);
}

TEST(DiscOutline, OfAMoonThatIsNotBeforeTheCameraIsNone) {
  auto behind = camera(0.6);
  behind.direction = {219, 14, -9};
  EXPECT_FALSE(disc_outline(behind));
}

TEST(DiscWindow, HoldsEveryPixelThatTheMoonTouchesInAnyFrame) {
  for (const double field : {0.3, 0.6, 3.}) {
    auto other = camera(field);
    other.direction = {-219, -13, 8.5};
    const std::vector cameras{camera(field), other};
    const auto window = disc_window(cameras);
    ASSERT_TRUE(window);
    std::size_t left = 90, right = 0, top = 60, bottom = 0;
    for (const auto& from : cameras)
      for (std::size_t row = 0; row < 60; ++row)
        for (std::size_t column = 0; column < 90; ++column) {
          const auto x = static_cast<double>(column) + 0.5, y = static_cast<double>(row) + 0.5;
          if (covered_share(*disc_outline(from), x, y) == 0) continue;
          left = std::min(left, column), right = std::max(right, column + 1);
          top = std::min(top, row), bottom = std::max(bottom, row + 1);
        }
    for (const auto& [edge, touched] : {std::pair{window->left, left}, {window->top, top}}) {
      EXPECT_LE(edge, touched);
      EXPECT_GE(edge + 3, touched) << "a pixel more, and what a straight edge leaves out";
    }
    for (const auto& [edge, touched] :
         {std::pair{window->right, right}, {window->bottom, bottom}}) {
      EXPECT_GE(edge, touched);
      EXPECT_LE(edge, touched + 3);
    }
  }
}

TEST(DiscWindow, IsNoneWhereTheMoonIsInNoFrameOrHasNoEdge) {
  auto beside = camera(0.6);
  beside.direction = {-219, 30, 9};
  auto behind = camera(0.6);
  behind.direction = {219, 14, -9};
  EXPECT_FALSE(disc_window(std::vector{beside}));
  EXPECT_FALSE(disc_window(std::vector{camera(0.6), behind}));
  EXPECT_TRUE(disc_window(std::vector{camera(0.6), beside}));
}

TEST(DiscOutline, ComesBackFromAHeaderToTheLastDigit) {
  const auto outline = *disc_outline(camera(0.6));
  const auto again = outline_in(text_of(outline));
  ASSERT_TRUE(again);
  EXPECT_EQ(again->x, outline.x);
  EXPECT_EQ(again->xy, outline.xy);
  EXPECT_EQ(again->yy, outline.yy);
  for (const char* none :
       {"", "1,2,3,4", "1,2,3,4,5,6", "1,2,-3,0,5", "1,2,1,9,1", "nan,2,1,0,1", "1,2,inf,0,x"})
    EXPECT_FALSE(outline_in(none)) << none;
}

}  // namespace coppermoon::uses::disc_outline_test
