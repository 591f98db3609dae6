// SPDX-License-Identifier: MIT
#include "uses/picture/clear_sky.h"

#include "atmosphere/sky_luminance.h"
#include "colour/working_space.h"
#include "support/testing.h"
#include "uses/light/spectral_bands.h"

namespace coppermoon::uses::scattered_colour_test {

using algebra::degrees;

constexpr ColourIndices sunlit{0.653, 0.356};

double luminance(const Rgb& light) { return colour::luminance(picture_space, light); }

TEST(ScatteredColour, OfSunlightIsNearlyWhiteAndOfRedLightRed) {
  const auto sun = colour_of(spectrum_of(sunlit));
  EXPECT_WITHIN(luminance(sun), 1, 1e-9, "normalised");
  EXPECT_WITHIN(sun[0] / sun[2], 1.2, 0.1, "sunlight above the air: 5900 K, D65 6500 K");
  const auto eclipsed = colour_of(spectrum_of({2.2, 1.3}));
  EXPECT_GT(eclipsed[0], 3 * eclipsed[2]);
}

TEST(ScatteredColour, HasTheIndicesThatItIsGiven) {
  const auto white = spectrum_of(sunlit), red = spectrum_of({1.653, 0.856});
  // bands of 10 nm from 380: 435 to 445 is the 6th and 7th, 545 to 555 the 17th and 18th
  const auto dimmed_mag = [&](std::size_t band) {
    return -2.5 * std::log10((red[band] + red[band - 1]) / (white[band] + white[band - 1]));
  };
  EXPECT_WITHIN(dimmed_mag(6) - dimmed_mag(17), 1, 0.02,
                "B - V is 1 mag more, at 440 and 550 nm; two bands each");
}

TEST(ScatteredColour, IsBlueOverheadPalerLowAndNearTheLamp) {
  const atmosphere::ObserverAir air;
  const ScatteredColour sky(air, sunlit, degrees(45));
  const auto zenith = sky.along(degrees(90)), low = sky.along(degrees(3));
  const auto blue = [](const Rgb& light) { return light[2] / light[0]; };
  EXPECT_GT(blue(zenith.molecules), 2);
  EXPECT_LT(blue(low.molecules), blue(zenith.molecules));
  EXPECT_LT(blue(zenith.aerosol), blue(zenith.molecules));
  const ScatteredColour setting(air, sunlit, degrees(1));
  EXPECT_LT(blue(setting.along(degrees(45)).molecules), blue(sky.along(degrees(45)).molecules));
}

TEST(ScatteredColour, OfAFullMoonHasTheColourOfParanalsMoonlitSky) {
  // ESO SkyCalc 1.4.3, Cerro Paranal: zenith, full Moon at 45 degrees: B - V = 0.19 and V - R = 0.01 with the
  // night's own light. The same integrals by our bands, of channels that stand for B and R
  const atmosphere::ObserverAir air{.aerosol_optical_depth = 0.04, .elevation_m = 2635};
  const ScatteredColour sky(air, {0.91, 0.56}, degrees(45));  // a full Moon
  const auto [molecules, aerosol] = atmosphere::scattering_terms(degrees(45));
  const auto pair = sky.along(degrees(90));
  Rgb light{};
  for (std::size_t k = 0; k < 3; ++k)
    light[k] = molecules * pair.molecules[k] + aerosol * pair.aerosol[k];
  const auto same = colour_of(spectrum_of({0.19, 0.01}));
  EXPECT_WITHIN_RELATIVE(light[2] / light[0], same[2] / same[0], 0.4,
                         "the aerosol's share: the law has that of Mauna Kea");
}

}  // namespace coppermoon::uses::scattered_colour_test
