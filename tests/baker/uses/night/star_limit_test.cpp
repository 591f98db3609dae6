// SPDX-License-Identifier: MIT
#include "uses/night/star_limit.h"

#include <cmath>
#include <numbers>

#include "atmosphere/sky_luminance.h"
#include "support/within.h"

namespace coppermoon::uses {
namespace {

TEST(StarLimit, OfADarkSkyIsTheSixthMagnitude) {
  EXPECT_WITHIN(faintest_star(atmosphere::luminance_of_magnitude_cd_m2(21.6)), 6.5, 0.15,
                "mag: Schaefer (1990) has 6.5 to 6.6 for the darkest sites");
  EXPECT_WITHIN(faintest_star(atmosphere::luminance_of_magnitude_cd_m2(18)), 4.2, 0.3,
                "mag: of a bright suburb, Bortle (2001) has 4.6 to 4.9 at 18.5, some 4 at 18");
}

TEST(StarLimit, AFullMoonBrightensTheSkyAsMeasured) {
  // Krisciunas & Schaefer (1991), Fig. 3: at a full Moon some 2000 nL at 60 degrees from it, above
  // 1000 nL all over the sky
  const double nanolambert = 1e-5 / std::numbers::pi;
  const double sky = moonlit_sky_cd_m2(-12.73, algebra::degrees(45)) / nanolambert;
  EXPECT_GT(sky, 500);
  EXPECT_LT(sky, 3000);
  EXPECT_EQ(moonlit_sky_cd_m2(-12.73, algebra::degrees(-1)), 0);
  EXPECT_WITHIN(moonlit_sky_cd_m2(-2.73, algebra::degrees(45)) * 1e4,
                moonlit_sky_cd_m2(-12.73, algebra::degrees(45)), 1e-9, "ten magnitudes are 1e4");
}

}  // namespace
}  // namespace coppermoon::uses
