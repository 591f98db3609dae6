// SPDX-License-Identifier: MIT
#include "atmosphere/aerosol.h"

#include "support/testing.h"

namespace coppermoon::atmosphere::aerosol_test {

using algebra::nanometres;

TEST(TroposphericProfile, IsAShareOfTheColumn) {
  double sum = 0;
  for (double h = 0.5; h < 100e3; h += 1) sum += tropospheric_profile_per_m(2e3, h);
  EXPECT_WITHIN(sum, 1.0, 1e-7, "midpoints of 1 m in a scale height of 2000 m: 1/24 of (1/2000)²");
}

// 23 km of visibility at 3 and 10 km: 0.0346 and 0.00114 per km in spring and summer, 0.0272 and
// 0.000787 in fall and winter.
TEST(TroposphericProfile, FallsAsThatOfLowtranDoes) {
  const double fall = tropospheric_profile_per_m(2e3, 3e3) / tropospheric_profile_per_m(2e3, 10e3);
  EXPECT_GT(fall, 0.0346 / 0.00114);
  EXPECT_LT(fall, 0.0272 / 0.000787);
}

// Kent et al. (1998): 1e-4 and 7e-4 per km at 1.02 µm; 2.2 times that is 550 nm by Ångström's 1.3:
// (1020/550)^1.3 = 2.23.
TEST(FreeTroposphere, HasWhatSageSaw) {
  EXPECT_WITHIN_RELATIVE(free_troposphere_per_m(algebra::degrees(-70)), 2.23e-7, 0.02,
                         "2.2 for 2.23");
  EXPECT_WITHIN_RELATIVE(free_troposphere_per_m(algebra::degrees(70)), 7 * 2.23e-7, 0.02,
                         "2.2 for 2.23");
  EXPECT_EQ(free_troposphere_profile(11e3, 7e3), 1);
  EXPECT_EQ(free_troposphere_profile(11e3, 13e3), 0);
}

// 1.3 ln 2 = 0.90109, so 780 nm scatters 2^−1.3 of 390 nm.
TEST(TroposphericSpectrum, FollowsAngstromsLaw) {
  EXPECT_EQ(tropospheric_spectrum(nanometres(550)), 1);
  EXPECT_WITHIN(tropospheric_spectrum(nanometres(780)) / tropospheric_spectrum(nanometres(390)),
                std::exp(-0.9010913), 1e-7, "the exponent is rounded to 7 digits");
  EXPECT_THROW(tropospheric_spectrum(nanometres(379.99)), algebra::Error);
}

}  // namespace coppermoon::atmosphere::aerosol_test
