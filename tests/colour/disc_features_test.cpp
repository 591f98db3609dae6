// SPDX-License-Identifier: MIT
#include "colour/disc_features.h"

#include "support/testing.h"

namespace coppermoon::colour::disc_features_test {

using Picture = algebra::Grid<float>;

const Disc disc{60, 50, 30};

/// Light by place from the disc's centre [pixels] inside of it, `sky` by column outside.
Picture picture_of(
    const std::function<double(double x, double y)>& light,
    const std::function<double(std::size_t)>& sky = [](std::size_t) { return 0.; }) {
  Picture picture(100, 120);
  for (std::size_t r = 0; r < picture.rows(); ++r)
    for (std::size_t c = 0; c < picture.columns(); ++c) {
      const double x = static_cast<double>(c) + 0.5 - disc.x_px,
                   y = static_cast<double>(r) + 0.5 - disc.y_px;
      picture(r, c) = static_cast<float>(std::hypot(x, y) < disc.radius_px ? light(x, y) : sky(c));
    }
  return picture;
}

double even(double, double) { return 1; }

TEST(ClippedShare, IsOfTheDiscAndOfWhatIsNearestToTheLargestValue) {
  EXPECT_EQ(clipped_share(picture_of(even), disc), 1);
  const auto half = [](double x, double) { return x < 0 ? 1 : 0.5; };
  EXPECT_EQ(clipped_share(picture_of(half), disc), 0.5) << "symmetric about its middle column";
  const auto nearly = [](double x, double) { return x < 0 ? 1 : 0.995; };
  EXPECT_EQ(clipped_share(picture_of(nearly), disc), 1) << "within a hundredth";
  EXPECT_EQ(clipped_share(picture_of(even), {-100, 50, 30}), 0) << "outside of the picture";
}

TEST(DeepClipping, IsOfABrightestThatIsFourTimesWhatSaturates) {
  for (const auto& [brightest, deep] : {std::pair{4.1, true}, std::pair{3.9, false}}) {
    const auto light = [&, most = brightest](double x, double) { return x < -15 ? most : 1; };
    // beyond half a radius lies 1/3 − √3 / 4π of a disc
    EXPECT_EQ(is_deep(picture_of(light), disc, 0.3), deep) << brightest;
  }
}

TEST(DiscFeatures, OfAnEvenDiscHaveNoContrastButBeyondTheLimb) {
  const auto made = features_of(picture_of(even), disc, 30, {});
  ASSERT_EQ(made.contrast.columns(), 78U) << "1.3 radii, both ways";
  for (std::size_t r = 0; r < 78; ++r)
    for (std::size_t c = 0; c < 78; ++c) {
      const double away = std::hypot(static_cast<double>(c) - 38.5, static_cast<double>(r) - 38.5);
      if (away < 24) {
        EXPECT_WITHIN(made.contrast(r, c), 0., 1e-3, "the floor is 1e-6 of light; floats");
        EXPECT_WITHIN(made.weight(r, c), 1., 1e-3, "the same");
      } else if (away > 38) {
        EXPECT_WITHIN(made.contrast(r, c), -1., 1e-3, "black");
      }
    }
  EXPECT_EQ(made.floor, 1e-6) << "no noise: the least there is";
}

/// Three σ of columns that alternate between 0 and 0.02: neighbours along a diagonal differ by 0.02, and half of a normal
/// difference of √2 σ is below 0.9539 σ.
TEST(DiscFeatures, HaveTheSkysNoiseAsTheirFloor) {
  const auto sky = [](std::size_t column) { return column % 2 == 0 ? 0. : 0.02; };
  const double floor = features_of(picture_of(even, sky), disc, 30, {}).floor;
  EXPECT_WITHIN_RELATIVE(floor, 3 * 0.02 / 0.9539, 0.025,
                         "the sky's median, 0 or 0.02, is taken off the disc's light");
  EXPECT_EQ(features_of(picture_of(even, sky), disc, 30, {.floor = 0.5}).floor, 0.5);
}

/// A grating of 8 pixels, blurred by three boxes of 3: sinc cubed of its contrast is left, over an even mean of 15 pixels.
TEST(DiscFeatures, HaveTheContrastOfAGrating) {
  constexpr double contrast = 0.2, period_px = 8;
  const auto light = [&](double x, double) {
    return 1 + contrast * std::sin(2 * std::numbers::pi * x / period_px);
  };
  const auto made = features_of(picture_of(light), disc, 30, {});
  double most = 0;
  for (std::size_t c = 28; c < 50; ++c)
    most = std::max(most, static_cast<double>(made.contrast(38, c)));
  const double a = std::numbers::pi / period_px, box = std::sin(3 * a) / (3 * std::sin(a));
  const double peak = std::cos(a);  // of a sample beside the crest
  EXPECT_WITHIN_RELATIVE(most, contrast * box * box * box * peak, 0.02,
                         "the local mean keeps 1 % of the grating");
}

TEST(DiscFeatures, HaveNoWeightAtAClippedLimbNorBeyondThePicture) {
  const auto half = [](double x, double) { return x < 0 ? 1 : 0.5; };
  const auto made = features_of(picture_of(half), disc, 30, {.clipped = 0.5});
  EXPECT_EQ(made.weight(39, 39 - 29), 0) << "clipped, at the limb";
  EXPECT_GT(made.weight(39, 39 - 20), 0.9) << "clipped, within";
  EXPECT_GT(made.weight(39, 39 + 25), 0.9) << "not clipped";
  const auto deeply = features_of(picture_of(half), disc, 30, {.clipped = 0.5, .deeply = true});
  EXPECT_EQ(deeply.weight(39, 39 - 20), 0) << "clipped deeply";
  const Disc at_the_edge{10, 50, 30};
  const auto cut = features_of(picture_of(even), at_the_edge, 30, {});
  EXPECT_EQ(cut.weight(39, 39 - 15), 0) << "left of the picture";
}

}  // namespace coppermoon::colour::disc_features_test
