// SPDX-License-Identifier: MIT
#include "uses/light/photometer.h"

#include <glm/geometric.hpp>

#include "almanac/instant.h"
#include "support/testing.h"

namespace coppermoon::uses::disc_brightness_test {

constexpr std::size_t rows = 180;

almanac::SkyState mid_eclipse() {
  return almanac::sky_at(almanac::instant_from_utc("2008-02-21T03:26:05Z"));
}

/// A sphere of radius R at distance d fills 2π (1 − cos a), sin a = R / d.
double solid_angle_of_sphere(const almanac::SkyState& sky) {
  const double sine = in_metres(almanac::lunar_radius) / glm::length(sky.moon_m);
  return 2 * std::numbers::pi * (1 - std::sqrt(1 - sine * sine));
}

texture::Image uniform(float luminance) {
  texture::Image image(2 * rows, rows, {"Y"});
  for (float& value : image.values) value = luminance;
  return image;
}

TEST(SolidAngleOfDisc, IsThatOfASphere) {
  const auto sky = mid_eclipse();
  EXPECT_WITHIN_RELATIVE(solid_angle_of_disc(rows, sky), solid_angle_of_sphere(sky), 2e-4,
                         "a texel is seen or not: 1e-4 at 180 rows");
}

TEST(IrradianceOfDisc, IsLuminanceTimesSolidAngle) {
  const auto sky = mid_eclipse();
  EXPECT_WITHIN_RELATIVE(irradiance_of_disc(uniform(5000), sky)[0],
                         5000 * solid_angle_of_disc(rows, sky), 1e-6,
                         "the same sum, luminances in single precision");
}

TEST(IrradianceOfDisc, KnowsNothingOfTheFarSide) {
  const auto sky = mid_eclipse();
  auto image = uniform(0);
  for (std::size_t r = rows / 6; r < rows - rows / 6; ++r)
    for (std::size_t c = 0; c < rows / 3; ++c) image(r, c, 0) = image(r, 2 * rows - 1 - c, 0) = 1;
  EXPECT_EQ(irradiance_of_disc(image, sky)[0], 0)
      << "longitudes beyond 120 degrees, latitudes to 60";
}

TEST(DanjonEstimate, InvertsVitalsFormula) {
  for (const double danjon : {0.5, 1., 2., 3., 3.9}) {
    const double magnitude = 4.2 - 3 * danjon + danjon * danjon / 4;
    EXPECT_WITHIN(danjon_estimate(magnitude), danjon, 1e-9, "rounding");
  }
}

TEST(DanjonEstimate, StaysOnTheScale) {
  EXPECT_EQ(danjon_estimate(20), 0);
  EXPECT_EQ(danjon_estimate(-12), 4);
}

}  // namespace coppermoon::uses::disc_brightness_test
