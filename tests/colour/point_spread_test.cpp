// SPDX-License-Identifier: MIT
#include "colour/point_spread.h"

#include "support/testing.h"

namespace coppermoon::colour::point_spread_test {

using std::numbers::pi;
using Picture = algebra::Grid<double>;

constexpr double nm = 1e-9;

Picture star(std::size_t side) {
  Picture picture(side, side);
  picture(side / 2, side / 2) = 1;
  return picture;
}

double sum(const Picture& picture) {
  return std::reduce(picture.values().begin(), picture.values().end());
}

/// Contrast that a star's picture leaves of stripes along a row.
double contrast(const Picture& picture, double cycles_per_pixel) {
  const double middle = static_cast<double>(picture.columns() / 2);
  double left = 0;
  for (std::size_t r = 0; r < picture.rows(); ++r)
    for (std::size_t c = 0; c < picture.columns(); ++c)
      left +=
          picture(r, c) * std::cos(2 * pi * cycles_per_pixel * (static_cast<double>(c) - middle));
  return left;
}

/// Light within an angle of a point.
double encircled(const Aperture& aperture, double wavelength_nm, double angle_rad) {
  constexpr int steps = 20000;
  double light = 0;
  for (int i = 0; i < steps; ++i) {
    const double theta = (i + 0.5) * angle_rad / steps;
    light += 2 * pi * theta * diffraction_spread_per_sr(aperture, wavelength_nm, theta);
  }
  return light * angle_rad / steps;
}

TEST(Diffraction, PutsEightyFourHundredthsIntoTheAiryDisc) {
  // 1 − J₀² − J₁² at the first zero of J₁, 3.8317: Born & Wolf, table 8.2
  EXPECT_WITHIN(encircled({0.127, 0}, 550, 1.21967 * 550 * nm / 0.127), 0.83778, 1e-5,
                "the midpoint rule's, and the table's digits");
}

TEST(Diffraction, ThroughARingLeavesLessInTheDiscAndAllInTheEnd) {
  // ε = 0.3: 0.682 of the light within the first dark ring at x = 3.4 (Born & Wolf, section 8.6.2:
  // the ring moves inwards), and the tail beyond x falls as 2 / (π x (1 − ε))
  const Aperture open{0.2, 0}, ring{0.2, 0.3};
  const double airy = 1.21967 * 550 * nm / 0.2;
  EXPECT_LT(encircled(ring, 550, airy), 0.72);
  EXPECT_GT(encircled(ring, 550, airy), 0.66);
  constexpr double x = 400;
  const double far = x / pi * 550 * nm / 0.2;
  EXPECT_WITHIN(encircled(ring, 550, far), 1 - 2 / (pi * x * (1 - 0.3)), 2e-4,
                "the tail's own ripples, 1/x^2 of it and the midpoint rule");
  EXPECT_WITHIN(encircled(open, 550, far), 1 - 2 / (pi * x), 2e-4, "the same");
}

TEST(Blurred, StarKeepsTheContrastOfARoundAperture) {
  // 2/π (acos s − s √(1 − s²)), s: frequency over that where contrast ends; the mean over a pixel
  // takes sin(πν)/πν more
  constexpr double pixel_rad = 1e-6, wavelength_nm = 600, widths = 4;  // λ/D in pixels
  const Blur blur{{wavelength_nm * nm / (widths * pixel_rad), 0}, wavelength_nm, 0};
  const auto picture = blurred(star(512), blur, pixel_rad);
  const double whole = contrast(picture, 0);
  for (const double frequency : {0.02, 0.05, 0.1, 0.15, 0.2}) {
    const double s = frequency * widths;
    const double transfer = 2 / pi * (std::acos(s) - s * std::sqrt(1 - s * s)) *
                            std::sin(pi * frequency) / (pi * frequency);
    EXPECT_WITHIN(contrast(picture, frequency) / whole, transfer, 4e-3,
                  "the light beyond the frame: 2 / (π² 64) of it");
  }
  EXPECT_WITHIN(contrast(picture, 0.3) / whole, 0., 4e-3, "as before: beyond 1/4 there is none");
}

TEST(Blurred, StarKeepsTheContrastOfSeeing) {
  constexpr double pixel_rad = 5e-6, width_px = 4;
  const auto picture = blurred(star(512), {{}, 0, width_px * pixel_rad}, pixel_rad);
  for (const double frequency : {0.01, 0.03, 0.06, 0.1, 0.2})
    EXPECT_WITHIN(contrast(picture, frequency),
                  std::exp(-3.44 * std::pow(frequency * width_px / 0.976, 5. / 3)), 1e-3,
                  "light beyond the frame: a far wing falls as angle^(-11/3)");
}

TEST(Blurred, StarIsAsWideAsItsSeeing) {
  constexpr double pixel_rad = 1e-6, width_px = 20;
  const auto picture = blurred(star(256), {{}, 0, width_px * pixel_rad}, pixel_rad);
  const double peak = picture(128, 128);
  EXPECT_WITHIN(picture(128, 128 + 10) / peak, 0.5, 0.01, "0.976 is rounded to three digits");
  EXPECT_WITHIN(picture(128 - 10, 128) / peak, 0.5, 0.01, "the same");
}

/// Light of a point at a distance r from its middle, by the transfer's Hankel transform.
double seeing_spread(double r, double width) {
  constexpr int steps = 20000;
  const double step = 4 / width / steps;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double frequency = (i + 0.5) * step;
    sum += std::exp(-3.44 * std::pow(frequency * width / 0.976, 5. / 3)) *
           ::j0(2 * pi * frequency * r) * frequency * step;
  }
  return 2 * pi * sum;
}

TEST(Blurred, StarOfSeeingNarrowerThanAPixelIsThatSpreadAtItsMiddles) {
  for (const double width : {0.04, 0.3, 0.8, 2.}) {
    const auto picture = blurred(star(256), {{}, 0, width * 1e-5}, 1e-5);
    for (const auto& [x, y] : {std::pair{1, 0}, {1, 1}, {0, 3}})
      EXPECT_WITHIN(picture(128 + y, 128 + x) / picture(128, 128),
                    seeing_spread(std::hypot(x, y), width) / seeing_spread(0, width), 2e-8,
                    "the integral's 20000 steps, and stars that the transform repeats")
          << width;
  }
}

TEST(Blurred, PictureKeepsItsLightAndIsNowhereBlackerThanBlack) {
  for (const double pixel_rad : {2e-7, 1e-6, 5e-6, 1e-4}) {
    const Blur blur{{0.127, 0.31}, 550, 1e-5};
    const auto picture = blurred(star(300), blur, pixel_rad);
    // a star's light within 150 pixels: of diffraction by the tail, of seeing as good as all
    EXPECT_GT(*std::ranges::min_element(picture.values()), -1e-15);
    const double beyond = 2 * 550 * nm / 0.127 / (pi * pi * 0.69 * 150 * pixel_rad);
    EXPECT_GT(sum(picture), 1 - 1.5 * beyond - 0.2 * std::pow(1e-5 / (150 * pixel_rad), 5. / 3))
        << pixel_rad;
    EXPECT_LT(sum(picture), 1 + 1e-12);
  }
}

TEST(Blurred, OfWhatIsAlikeEverywhereStaysAlike) {
  const Picture even(40, 70, 3.5);
  const auto result = blurred(even, {{0.1, 0.3}, 550, 2e-5}, 1e-5);
  for (const double value : result.values()) EXPECT_WITHIN(value, 3.5, 1e-12, "rounding");
}

TEST(Blurred, WithPixelsLargerThanTheSpreadIsAsItWas) {
  const double width = 550 * nm / 0.2;
  EXPECT_EQ(blurred(star(64), {{0.2, 0}, 550, 0}, 100 * width)(32, 32), 1);
  // just before it is left out: from anywhere in a pixel of 30 spreads past four straight edges, each
  // taking 1 / (pi^2 d) at d spreads from it
  const double within = blurred(star(64), {{0.2, 0}, 550, 0}, 30 * width)(32, 32);
  EXPECT_LT(within, 1);
  EXPECT_GT(within, 0.93);
}

TEST(Blurred, MovesNothing) {
  const auto picture = blurred(star(101), {{0.1, 0.2}, 550, 3e-5}, 1e-5);
  for (std::size_t i = 0; i < 50; ++i) {
    EXPECT_WITHIN(picture(50, 50 - i), picture(50, 50 + i), 1e-14, "rounding");
    EXPECT_WITHIN(picture(50 - i, 50), picture(50, 50 + i), 1e-14, "rounding");
  }
}

TEST(Blurred, RefusesWhatNoTelescopeIs) {
  EXPECT_THROW(blurred(star(8), {{0, 0}, 550, 0}, 1e-6), algebra::Error);
  EXPECT_THROW(blurred(star(8), {{0.1, 0.95}, 550, 0}, 1e-6), algebra::Error);
  EXPECT_THROW(blurred(star(8), {{0.1, 0}, 550, -1}, 1e-6), algebra::Error);
  EXPECT_THROW(blurred(star(8), {{0.1, 0}, 550, 0}, 0), algebra::Error);
}

}  // namespace coppermoon::colour::point_spread_test
