// SPDX-License-Identifier: MIT
#include "uses/night/night_light.h"

#include "atmosphere/sky_luminance.h"
#include "support/testing.h"

namespace coppermoon::uses::star_limit_test {

TEST(StarLimit, OfADarkSkyIsTheSixthMagnitude) {
  EXPECT_WITHIN(faintest_star(atmosphere::luminance_of_magnitude_cd_m2(21.6)), 6.5, 0.15,
                "mag: Schaefer (1990) has 6.5 to 6.6 for the darkest sites");
  EXPECT_WITHIN(faintest_star(atmosphere::luminance_of_magnitude_cd_m2(18)), 4.2, 0.3,
                "mag: of a bright suburb, Bortle (2001) has 4.6 to 4.9 at 18.5, some 4 at 18");
}

}  // namespace coppermoon::uses::star_limit_test
