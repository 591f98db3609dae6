// SPDX-License-Identifier: MIT
#include "colour/glow.h"

#include "colour/camera.h"
#include "support/testing.h"

namespace coppermoon::colour::glow_test {

using std::numbers::pi;

constexpr double arcsec = pi / 180 / 3600;

/// Integral over angles by the midpoint rule on their logarithm.
double within(double angle_rad) {
  constexpr int steps = 200000;
  const double first = std::log(1e-9), step = (std::log(angle_rad) - first) / steps;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double theta = std::exp(first + (i + 0.5) * step);
    sum += 2 * pi * theta * theta * glow_spread_per_sr(theta) * step;
  }
  return sum;
}

TEST(Glow, WithinAnAngleIsTheIntegralOfItsSpread) {
  for (const double angle : {5 * arcsec, 60 * arcsec, 0.5 * pi / 180, 6 * pi / 180})
    EXPECT_WITHIN(glow_within(angle), within(angle), 1e-7, "the midpoint rule on 200000 steps");
  EXPECT_WITHIN(glow_within(1e6), 1, 1e-9, "all of it, but for (6 degrees / angle)^2");
}

TEST(Glow, IsThatOfPublishedStarImages) {
  // King (1971): an inverse square over a factor of 1000 in angle holds 5 % of a star's light; as
  // SkyMaker has it (Bertin 2009), 16 mag/arcsec² at 1′ of a star of magnitude 0
  const double at_1_arcmin = camera_named("paper").glow * glow_spread_per_sr(60 * arcsec);
  EXPECT_WITHIN(-2.5 * std::log10(at_1_arcmin * arcsec * arcsec), 16, 0.5,
                "magnitudes are printed to one; telescopes differ by more");
  // the slope: 2, as far as a and b are away
  for (const double angle : {3., 10., 60.}) {
    const double slope = std::log(glow_spread_per_sr(angle * 60 * arcsec * 0.9) /
                                  glow_spread_per_sr(angle * 60 * arcsec * 1.1)) /
                         std::log(1.1 / 0.9);
    EXPECT_WITHIN(slope, 2, 0.06, "20 arcsec of 3 arcmin, and 1 degree of 6: squared, twice");
  }
}

/// A crescent: sunlit ground of 1 in a disc, but for what another disc covers, where there is little.
Image crescent(std::size_t rows, std::size_t columns, double radius) {
  Image picture(rows, columns);
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = 0; c < columns; ++c) {
      const double y = static_cast<double>(r) - static_cast<double>(rows) / 2,
                   x = static_cast<double>(c) - static_cast<double>(columns) / 2;
      if (std::hypot(x, y) > radius) continue;
      const float light = std::hypot(x + radius / 3, y) < radius ? 1e-5F : 1.F;
      picture(r, c) = {light, 0.5F * light, 0.25F * light};
    }
  return picture;
}

/// A pixel's mean of the glow, by itself on 40 x 40 places.
double over_a_pixel(double x, double y, double pixel_rad) {
  constexpr int parts = 40;
  double sum = 0;
  for (int i = 0; i < parts; ++i)
    for (int j = 0; j < parts; ++j)
      sum += glow_spread_per_sr(
          pixel_rad * std::hypot(x + (i + 0.5) / parts - 0.5, y + (j + 0.5) / parts - 0.5));
  return sum / (parts * parts) * pixel_rad * pixel_rad;
}

TEST(Glow, OverTheUmbraIsTheSumOfAllThatTheCrescentScatters) {
  constexpr double share = 0.05;
  const double pixel = 40 * arcsec;
  const auto scene = crescent(36, 55, 15);
  const auto picture = with_glow(scene, share, pixel);
  for (const auto& [row, column] :
       {std::pair<std::size_t, std::size_t>{18, 25}, {18, 32}, {10, 20}, {0, 0}, {35, 54}}) {
    double sum = (1 - share) * scene(row, column)[0];
    for (std::size_t r = 0; r < scene.rows(); ++r)
      for (std::size_t c = 0; c < scene.columns(); ++c)
        sum += share * scene(r, c)[0] *
               over_a_pixel(static_cast<double>(c) - static_cast<double>(column),
                            static_cast<double>(r) - static_cast<double>(row), pixel);
    EXPECT_WITHIN_RELATIVE(picture(row, column)[0], sum, 2e-4,
                           "40 steps across a pixel of two inner radii: 1e-4 of the nearest");
    EXPECT_WITHIN_RELATIVE(picture(row, column)[1], 0.5 * picture(row, column)[0], 1e-6,
                           "single precision");
    EXPECT_WITHIN_RELATIVE(picture(row, column)[2], 0.25 * picture(row, column)[0], 1e-6,
                           "the same");
  }
  EXPECT_GT(picture(18, 25)[0], 20 * scene(18, 25)[0]) << "a crescent drowns the umbra beside it";
}

TEST(Glow, KeepsAllLightButWhatLeavesTheFrame) {
  constexpr double share = 0.1;
  for (const double pixel : {arcsec, 30 * arcsec, 0.01, 1.}) {
    Image star(81, 81);
    star(40, 40) = {1, 1, 1};
    const auto picture = with_glow(star, share, pixel);
    double light = 0;
    for (const auto& [red, green, blue] : picture.values()) light += green;
    double inside = 0;  // a square's share: the mean over directions
    constexpr int directions = 1000;
    for (int i = 0; i < directions; ++i)
      inside += glow_within(40.5 * pixel / std::cos(pi / 4 * (i + 0.5) / directions)) / directions;
    EXPECT_WITHIN(light, 1 - share + share * inside, 1e-6, "single precision of 6561 pixels");
  }
}

TEST(Glow, IsAlikeOnAllSidesAndComesBackFromNoEdge) {
  Image corner(64, 48);
  corner(0, 0) = {1, 1, 1};
  const auto picture = with_glow(corner, 0.05, 5 * arcsec);
  for (std::size_t r = 0; r < 48; ++r)
    EXPECT_WITHIN(picture(r, 0)[0], picture(0, r)[0], 1e-9, "single precision");
  for (std::size_t r = 1; r < 64; ++r) EXPECT_LT(picture(r, 0)[1], picture(r - 1, 0)[1]);
  EXPECT_LT(picture(63, 47)[2], picture(40, 30)[2]);
}

TEST(Glow, OfNothingIsNothing) {
  const auto scene = crescent(20, 30, 8);
  EXPECT_TRUE(std::ranges::equal(with_glow(scene, 0, arcsec).values(), scene.values()));
  EXPECT_TRUE(with_glow(Image(), 0.05, arcsec).empty());
  EXPECT_THROW(with_glow(scene, 0.6, arcsec), algebra::Error);
  EXPECT_THROW(with_glow(scene, 0.05, 0), algebra::Error);
}

}  // namespace coppermoon::colour::glow_test
