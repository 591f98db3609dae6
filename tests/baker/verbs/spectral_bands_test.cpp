// SPDX-License-Identifier: MIT
#include "verbs/spectral_bands.h"

#include <numbers>

#include "colour/cie_observer.h"
#include "support/within.h"

namespace coppermoon::verbs {
namespace {

TEST(SpectralBands, AreTwoHundredFrom380To780) {
  const auto edges = band_edges_nm(), centres = band_centres_nm();
  ASSERT_EQ(edges.size(), 201U);
  ASSERT_EQ(centres.size(), 200U);
  EXPECT_EQ(edges.front(), 380);
  EXPECT_EQ(edges.back(), 780);
  EXPECT_EQ(centres.front(), 381);
  EXPECT_EQ(centres.back(), 779);
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
  EXPECT_WITHIN(ratio_at(30), std::exp(-0.2366), 0.004, "printed every 50 nm");
  EXPECT_WITHIN(ratio_at(85), std::exp(-0.0972), 0.002, "printed every 50 nm");
}

TEST(MoonlightWeights, AreDimmedMoreNearTheHorizon) {
  const auto high = moonlight_weights(xyz(), atmosphere::Sightline{{}, algebra::degrees(60)}),
             low = moonlight_weights(xyz(), atmosphere::Sightline{{}, algebra::degrees(5)});
  EXPECT_LT(total(low, 1), total(high, 1));
  EXPECT_LT(total(low, 2) / total(low, 0), total(high, 2) / total(high, 0));
}

}  // namespace
}  // namespace coppermoon::verbs
