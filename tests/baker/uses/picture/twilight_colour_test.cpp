// SPDX-License-Identifier: MIT
#include "uses/picture/twilight_colour.h"

#include <cmath>

#include "colour/working_space.h"
#include "support/within.h"
#include "uses/light/spectral_bands.h"

namespace coppermoon::uses {
namespace {

using algebra::degrees;

double red_over_blue(const Rgb& light) { return light[0] / light[2]; }

TEST(TwilightColour, IsOrangeAboveTheSunAndBlueOverhead) {
  const TwilightColour dusk({}, degrees(-6));
  const double over_sun = red_over_blue(dusk.towards(degrees(3), degrees(0))),
               overhead = red_over_blue(dusk.towards(degrees(90), degrees(0))),
               opposite = red_over_blue(dusk.towards(degrees(3), degrees(180)));
  EXPECT_GT(over_sun, 2);
  EXPECT_LT(opposite, 1) << "the Earth's shadow";
  // Patat et al. (2006), fig. 8: the twilight zenith is bluer in B - V than sunlight, 0.65
  EXPECT_LT(overhead, red_over_blue(colour_of(spectrum_of(sunlight_colour()))));
}

TEST(TwilightColour, HasLuminance1AndNoStepInEveryDirection) {
  for (const double sun : {-60., -18., -17., -12., -6., -0.5, 0., 5.}) {
    const TwilightColour dusk({}, degrees(sun));
    for (double altitude = -5; altitude <= 90; altitude += 5)
      for (double aside = -180; aside <= 540; aside += 45) {
        const auto light = dusk.towards(degrees(altitude), degrees(aside));
        EXPECT_WITHIN(colour::luminance(picture_space, light), 1, 1e-6, "a mean of such colours");
        for (const double channel : light) EXPECT_GE(channel, 0);
        const auto beside = dusk.towards(degrees(altitude), degrees(aside + 1e-6));
        for (std::size_t k = 0; k < 3; ++k) EXPECT_WITHIN(beside[k], light[k], 1e-5, "no step");
      }
    const auto one = dusk.towards(degrees(20), degrees(50)),
               other = dusk.towards(degrees(20), degrees(-50));
    for (std::size_t k = 0; k < 3; ++k) EXPECT_WITHIN(one[k], other[k], 1e-12, "mirrored");
  }
}

TEST(TwilightColour, IsFiniteInAnyAir) {
  for (const double aerosol : {0., 10.})
    for (const double elevation_m : {-500., 1e5}) {
      const TwilightColour dusk(
          {.ozone_du = 0, .aerosol_optical_depth = aerosol, .elevation_m = elevation_m},
          degrees(-4));
      for (const double channel : dusk.towards(degrees(10), degrees(30)))
        EXPECT_TRUE(std::isfinite(channel));
    }
}

}  // namespace
}  // namespace coppermoon::uses
