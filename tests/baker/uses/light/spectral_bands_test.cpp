// SPDX-License-Identifier: MIT
#include "uses/light/spectral_bands.h"

#include "colour/cie_observer.h"
#include "support/testing.h"

namespace coppermoon::uses::spectral_bands_test {

TEST(SpectralBands, AreFourHundredFrom380To780) {
  const auto edges = band_edges_nm(), centres = band_centres_nm();
  ASSERT_EQ(edges.size(), 401U);
  ASSERT_EQ(centres.size(), 400U);
  EXPECT_EQ(edges.front(), 380);
  EXPECT_EQ(edges.back(), 780);
  EXPECT_EQ(centres.front(), 380.5);
  EXPECT_EQ(centres.back(), 779.5);
}

TEST(Wavelengths, AreTheMiddlesOfEvenBands) {
  EXPECT_EQ(wavelengths_nm(2), (std::vector<double>{480, 680}));
  EXPECT_EQ(wavelengths_nm(400), band_centres_nm());
  EXPECT_THROW(wavelengths_nm(0), algebra::Error);
  EXPECT_THROW(wavelengths_nm(401), algebra::Error);
}

TEST(AtWavelengths, SumsWhatRunsAsACubicExactly) {
  algebra::Grid<double> weights(1, 400);
  for (std::size_t b = 0; b < 400; ++b) weights(0, b) = 1 + std::sin(static_cast<double>(b) / 30);
  const auto cubic = [](double nm) { return std::pow((nm - 500) / 200, 3) + 2 * nm / 500; };
  double exact = 0;
  const auto bands = band_centres_nm();
  for (std::size_t b = 0; b < 400; ++b) exact += weights(0, b) * cubic(bands[b]);
  for (const int count : {4, 7, 40, 333, 400}) {
    const auto nodes = at_wavelengths(weights, count);
    const auto waves = wavelengths_nm(count);
    double sum = 0;
    for (std::size_t w = 0; w < waves.size(); ++w) sum += nodes(0, w) * cubic(waves[w]);
    EXPECT_WITHIN_RELATIVE(sum, exact, 1e-11, "rounding") << count;
  }
}

double total(const algebra::Grid<double>& weights, std::size_t channel) {
  double sum = 0;
  for (const double w : weights.row(channel)) sum += w;
  return sum;
}

algebra::Grid<double> xyz() { return colour::xyz_weights(band_edges_nm()); }

TEST(MoonlightWeights, MakeTheSunsIlluminanceOverPiOfAWhiteGround) {
  EXPECT_WITHIN_RELATIVE(
      total(moonlight_weights(xyz()), 1), 133.33e3 / std::numbers::pi, 0.01,
      "133.33 klx: Darula, Kittler & Gueymard (2005); spectra of the Sun differ by 1 %");
}

TEST(MoonlightWeights, AreRedderThanSunlight) {
  const auto moon = moonlight_weights(xyz());
  const double sun_x_over_z =
      0.3220 / (1 - 0.3220 - 0.3326);  // chromaticity of the Sun above the air
  EXPECT_GT(total(moon, 0) / total(moon, 2), 1.1 * sun_x_over_z);
}

TEST(MoonlightWeights, AreDimmedByRayleighAirInTheZenith) {
  const atmosphere::ObserverAir molecules{.ozone_du = 0, .aerosol_optical_depth = 0};
  const auto without = moonlight_weights(xyz()),
             with =
                 moonlight_weights(xyz(), atmosphere::Sightline{molecules, algebra::degrees(90)});
  const auto ratio_at = [&](std::size_t band) { return with(1, band) / without(1, band); };
  // Vertical optical depths at 1013 hPa by Bucholtz (1995), table 3 interpolated: 0.2358 at 441,
  // 0.0973 at 551 nm.
  EXPECT_WITHIN(ratio_at(61), std::exp(-0.2366), 0.004, "printed every 50 nm");
  EXPECT_WITHIN(ratio_at(171), std::exp(-0.0972), 0.002, "printed every 50 nm");
}

TEST(MoonlightWeights, AreDimmedMoreNearTheHorizon) {
  const auto high = moonlight_weights(xyz(), atmosphere::Sightline{{}, algebra::degrees(60)}),
             low = moonlight_weights(xyz(), atmosphere::Sightline{{}, algebra::degrees(5)});
  EXPECT_LT(total(low, 1), total(high, 1));
  EXPECT_LT(total(low, 2) / total(low, 0), total(high, 2) / total(high, 0));
}

TEST(ReddestAndBluest, KeepTheLuminanceOfSunlitGround) {
  const auto both = reddest_and_bluest(moonlight_weights(xyz()), band_centres_nm());
  ASSERT_EQ(both.rows(), 6U);
  const double mean = total(moonlight_weights(xyz()), 1);
  EXPECT_WITHIN_RELATIVE(total(both, 1), mean, 1e-12, "rounding");
  EXPECT_WITHIN_RELATIVE(total(both, 4), mean, 1e-12, "rounding");
  EXPECT_LT(total(both, 2), 0.88 * total(both, 5)) << "Z, blue: 0.15 to both sides, times 0.8";
}

/// Band by band, of ground between them and light that the shadow reddens.
TEST(ReddestAndBluest, MixedAreTheIntegralOverTheGroundsOwnSpectrum) {
  const auto bands = band_centres_nm();
  const auto weights = moonlight_weights(xyz());
  const auto both = reddest_and_bluest(weights, bands);
  const double c = -0.06, share = 0.5 + c / 0.3;
  for (std::size_t k = 0; k < 3; ++k) {
    double mixed = 0, integral = 0;
    for (std::size_t b = 0; b < bands.size(); ++b) {
      const double light = std::exp((bands[b] - 780) / 40);
      mixed += light * ((1 - share) * both(k, b) + share * both(3 + k, b));
      integral += light * weights(k, b) * (1 + c * colour_at(bands[b]));
    }
    EXPECT_WITHIN_RELATIVE(mixed, integral, 1e-12, "both are linear in c");
  }
}

}  // namespace coppermoon::uses::spectral_bands_test
