// SPDX-License-Identifier: MIT
#include "uses/light/photometer.h"

#include "support/testing.h"
#include "uses/light/spectral_bands.h"

namespace coppermoon::uses::photometric_bands_test {

/// ∫ λ R dλ / ∫ R dλ
double mean_wavelength_nm(std::size_t band) {
  const auto response = photometric_response(band_edges_nm());
  const auto centres = band_centres_nm();
  double sum = 0, weighted = 0;
  for (std::size_t w = 0; w < centres.size(); ++w) {
    sum += response(band, w);
    weighted += response(band, w) * centres[w];
  }
  return weighted / sum;
}

TEST(PhotometricBands, LieWhereBessellPutThem) {
  // Bessell (2005), ARA&A 43, 293, table 1: effective wavelengths, of an A0 star; flat light is a
  // little redder.
  EXPECT_WITHIN(mean_wavelength_nm(0), 436.1, 10, "an A0 star against flat light");
  EXPECT_WITHIN(mean_wavelength_nm(1), 544.8, 10, "an A0 star against flat light");
  EXPECT_WITHIN(mean_wavelength_nm(2), 640.7, 12,
                "an A0 star against flat light; R beyond 780 nm is left out");
}

TEST(PhotometricBands, PeakAtOne) {
  const auto response = photometric_response(band_edges_nm());
  for (std::size_t band = 0; band < response.rows(); ++band) {
    double most = 0;
    for (const double r : response.row(band)) most = std::max(most, r);  // bands of 1 nm
    EXPECT_WITHIN(most, 1, 0.01, "means over 1 nm around the peak");
  }
}

TEST(PhotometricBands, TheSunHasItsColours) {
  const auto bands = photometric_bands();
  ASSERT_EQ(bands.size(), 3U);
  EXPECT_EQ(bands[0].name, "B");
  EXPECT_WITHIN(bands[1].solar_magnitude, -26.76, 0.02,
                "Willmer (2018): V = -26.76; others -26.74 to -26.78");
  EXPECT_WITHIN(bands[0].solar_magnitude - bands[1].solar_magnitude, 0.65, 0.02,
                "solar twins: 0.63 to 0.67");
}

}  // namespace coppermoon::uses::photometric_bands_test
