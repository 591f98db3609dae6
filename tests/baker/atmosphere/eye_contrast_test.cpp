// SPDX-License-Identifier: MIT
#include "atmosphere/eye_contrast.h"

#include "support/testing.h"

namespace coppermoon::atmosphere::eye_contrast_test {

constexpr double arcminute = std::numbers::pi / 180 / 60;

double disc_sr(double diameter) { return std::numbers::pi * diameter * diameter / 4; }

TEST(EyeContrast, OfAPointIsThatOfStarsAtTheLimitOfTheNakedEye) {
  // A point's threshold illuminance is contrast times luminance times solid angle; V = 0 gives 2.54e-6 lux (Cox 1999).
  // Crumey (2014), section 3.1: under the darkest skies, of 21.8 mag/arcsec², limits of 6.0 to 6.6 mag for F of 2.4 to 1.4
  const double sky = std::pow(10, -0.4 * (21.8 - 12.58)), area = disc_sr(0.1 * arcminute),
               V = -2.5 * std::log10(contrast_threshold(sky, area) * sky * area / 2.54e-6);
  EXPECT_WITHIN(V, 6.3, 0.3, "mag: the range of observers' F");
}

TEST(EyeContrast, OfAWideFieldByDayIsTaylors) {
  EXPECT_WITHIN_RELATIVE(contrast_threshold(1000, 1), 2 * 0.00272, 0.01,
                         "Taylor's (1960) 0.27 % of a wide field, twice: what is left of R");
}

TEST(EyeContrast, HasNoStepWhereItsPartsMeet) {
  const double moon = disc_sr(31 * arcminute);
  for (const double sky : {0.0708, 0.193, 0.354, 3.40})
    EXPECT_WITHIN_RELATIVE(contrast_threshold(sky * 0.9999, moon),
                           contrast_threshold(sky * 1.0001, moon), 0.006,
                           "three digits of the published coefficients");
}

TEST(EyeContrast, FallsWithTheSkysLightAndTheLightsSize) {
  const double moon = disc_sr(31 * arcminute);
  double last = contrast_threshold(1e-5, moon);
  for (double sky = 1.3e-5; sky < 1000; sky *= 1.3) {
    const double now = contrast_threshold(sky, moon);
    EXPECT_LT(now, last * (sky < 30 ? 1.001 : 1.02)) << sky << ": level where Weber's law holds";
    EXPECT_LT(now, contrast_threshold(sky, moon / 4)) << sky;
    last = now;
  }
}

}  // namespace coppermoon::atmosphere::eye_contrast_test
