// SPDX-License-Identifier: MIT
#include "colour/circles.h"

#include "support/testing.h"

namespace coppermoon::colour::circles_test {

using Picture = algebra::Grid<float>;

/// An even disc over black, its edge as wide as a pixel; light of the left half, over the right's.
Picture picture_of(const Disc& disc, float left = 1) {
  Picture picture(90, 110);
  for (std::size_t r = 0; r < picture.rows(); ++r)
    for (std::size_t c = 0; c < picture.columns(); ++c) {
      const double x = static_cast<double>(c) + 0.5, y = static_cast<double>(r) + 0.5;
      const double inside = disc.radius_px - std::hypot(x - disc.x_px, y - disc.y_px) + 0.5;
      picture(r, c) = static_cast<float>(std::clamp(inside, 0., 1.)) * (x < disc.x_px ? left : 1);
    }
  return picture;
}

double distance_px(const Disc& one, const Disc& other) {
  return std::max({std::abs(one.x_px - other.x_px), std::abs(one.y_px - other.y_px),
                   std::abs(one.radius_px - other.radius_px)});
}

TEST(LikelyCircles, OfAnEvenDiscAreItsLimb) {
  for (const Disc& disc : {Disc{51.3, 44.8, 30}, Disc{20.5, 60.2, 8}, Disc{60, 40, 50}}) {
    const auto circles = likely_circles(picture_of(disc));
    ASSERT_EQ(circles.size(), 4U) << "one for each tone curve";
    for (const auto& circle : circles)
      EXPECT_LT(distance_px(circle, disc), 1.5) << disc.radius_px << ": pixels, as is stated";
  }
}

/// The half in shadow is a thousand times dimmer: curves that show it see the whole limb.
TEST(LikelyCircles, OfADiscHalfInShadowHaveItsWholeLimbAmongThem) {
  const Disc disc{55, 45, 32};
  const auto circles = likely_circles(picture_of(disc, 1e-3F));
  EXPECT_TRUE(std::ranges::any_of(circles, [&](const Disc& circle) {
    return distance_px(circle, disc) < 1.5;
  })) << "pixels, as is stated";
}

TEST(LikelyCircles, AreNoneWithoutADiscOrOfOneTooSmall) {
  EXPECT_TRUE(likely_circles(Picture(60, 60)).empty());
  for (const auto& circle : likely_circles(picture_of({50, 45, 2.5})))
    EXPECT_GE(circle.radius_px, 5) << "as is stated";
}

}  // namespace coppermoon::colour::circles_test
