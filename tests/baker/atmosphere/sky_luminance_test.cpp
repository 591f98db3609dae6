// SPDX-License-Identifier: MIT
#include "atmosphere/sky_luminance.h"

#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "algebra/error.h"
#include "support/within.h"

namespace coppermoon::atmosphere {
namespace {

using algebra::degrees;

TEST(SkyLuminance, IsThatOfTheAlmanacsIlluminance) {
  // Explanatory Supplement (1992), section 9.331: sunset 453 lx at -0.8 degrees, civil twilight ends at
  // 3.4 lx, nautical at 0.0081 lx, astronomical at 6.5e-4 lx
  const double night = luminance_of_magnitude_cd_m2(21.9);
  constexpr std::array<std::array<double, 2>, 4> all{
      {{-0.8, 453}, {-6, 3.4}, {-12, 0.0081}, {-18, 6.5e-4}}};
  for (const auto& [altitude, lx] : all)
    EXPECT_WITHIN_RELATIVE(
        (sky_luminance_cd_m2(degrees(altitude)) - night) * std::numbers::pi / 0.6, lx, 0.03,
        "the table's two or three digits, and the fit's 1 %");
}

TEST(SkyLuminance, IsThatOfTheZenithWithinItsFactorOfTwo) {
  // Patat et al. (2006), table 5: V = 11.84 + 1.518 d - 0.057 d^2, d degrees below 5
  for (const double below : {5., 7., 9., 12.}) {
    const double d = below - 5;
    const double zenith = luminance_of_magnitude_cd_m2(11.84 + 1.518 * d - 0.057 * d * d);
    const double ratio = sky_luminance_cd_m2(degrees(-below)) / zenith;
    EXPECT_GT(ratio, 0.5) << below;
    EXPECT_LT(ratio, 2.) << below;
  }
}

TEST(SkyLuminance, HasNoStepBetweenItsPieces) {
  for (const double altitude : {-0.8, -5., -12.})
    EXPECT_WITHIN_RELATIVE(sky_luminance_cd_m2(degrees(altitude + 1e-9)),
                           sky_luminance_cd_m2(degrees(altitude - 1e-9)), 0.02,
                           "coefficients of two decimals, of a logarithm");
  const double night = sky_luminance_cd_m2(degrees(-18.001));
  EXPECT_GT(sky_luminance_cd_m2(degrees(-17.999)), night);
  EXPECT_EQ(sky_luminance_cd_m2(degrees(-90)), night);
}

TEST(SkyLuminance, OfTheSunsOwnMagnitudeIsTheSuns) {
  // V = -26.76 over 6.79e-5 sr is 1.28e5 lx: 2.89 million square arc seconds. A sky is never so bright:
  // seen through a filter of 12.5 magnitudes, 1e-5 of its light
  const double sun_arcsec2 = 6.794e-5 / 2.3504e-11;
  EXPECT_WITHIN_RELATIVE(
      luminance_of_magnitude_cd_m2(-26.76 + 12.5 + 2.5 * std::log10(sun_arcsec2)) * 6.794e-5, 1.28,
      0.03, "of the magnitude's zero point in the literature");
}

TEST(SkyLuminance, RefusesADay) {
  EXPECT_THROW(sky_luminance_cd_m2(degrees(6)), algebra::Error);
  EXPECT_THROW(sky_luminance_cd_m2(degrees(-91)), algebra::Error);
  EXPECT_THROW(luminance_of_magnitude_cd_m2(99), algebra::Error);
}

}  // namespace
}  // namespace coppermoon::atmosphere
