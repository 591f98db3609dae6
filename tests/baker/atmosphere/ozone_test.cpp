// SPDX-License-Identifier: MIT
#include "atmosphere/ozone.h"

#include <gtest/gtest.h>

#include <cmath>

#include "algebra/error.h"
#include "baker/atmosphere/published_table.h"
#include "support/within.h"

namespace coppermoon::atmosphere {
namespace {

using algebra::nanometres;

// Bogumil's data lie 5 % above Serdyuchenko's, evenly over the band, as both groups report.
TEST(OzoneCrossSection, IsThatOfAnIndependentMeasurement) {
  const auto bogumil = published_table("baker/atmosphere/data/ozone_bogumil_2011.csv");
  const auto &nm = bogumil["wavelength_nm"], &section = bogumil["cross_section_m2"];
  double sum = 0;
  for (std::size_t i = 0; i < nm.size(); ++i) {
    const double ratio = section[i] / ozone_cross_section_m2(nanometres(nm[i]));
    EXPECT_WITHIN(ratio, 1.04, 0.03, "scatter of one 5 nm band, noise at the blue end")
        << nm[i] << " nm";
    sum += ratio;
  }
  EXPECT_WITHIN(sum / static_cast<double>(nm.size()), 1.045, 0.01, "mean of 18 bands");
}

TEST(OzoneCrossSection, HasTheFigureItsDocumentationStates) {
  EXPECT_WITHIN(ozone_cross_section_m2(nanometres(602)), 5.1e-25, 0.05e-25, "stated to 2 digits");
}

TEST(OzoneCrossSection, PeaksInTheOrangeAndAllButVanishesInTheViolet) {
  double peak_nm = 380;
  for (double nm = 380; nm <= 780; nm += 1)
    if (ozone_cross_section_m2(nanometres(nm)) > ozone_cross_section_m2(nanometres(peak_nm)))
      peak_nm = nm;
  EXPECT_WITHIN(peak_nm, 602.0, 5.0, "the table's bands are 5 nm wide");
  EXPECT_LT(ozone_cross_section_m2(nanometres(380)), 1e-27);
}

TEST(OzoneCrossSection, RefusesWavelengthsOutsideItsRange) {
  EXPECT_THROW(ozone_cross_section_m2(nanometres(379.99)), algebra::Error);
  EXPECT_THROW(ozone_cross_section_m2(nanometres(780.01)), algebra::Error);
}

TEST(OzoneFilter, CrossesAGrazedLayerAt22Kilometres) {
  const double sine = 6378.0 / (6378 + 22);
  EXPECT_WITHIN(grazing_ozone_air_mass, 2 / std::sqrt(1 - sine * sine), 0.05, "stated to 3 digits");
}

// By hand: 24.1 × 5.085e-25 m² (600 nm) × 300 × 2.6867e20 m⁻² = 0.98775
TEST(OzoneFilter, FollowsBeerLambert) {
  EXPECT_WITHIN(ozone_filter_yapo_cutler(nanometres(600), 300), std::exp(-0.98775), 2e-5,
                "the exponent is rounded to 5 digits");
  EXPECT_WITHIN(ozone_filter_yapo_cutler(nanometres(600), 600),
                std::pow(ozone_filter_yapo_cutler(nanometres(600), 300), 2), 1e-15, "rounding");
  EXPECT_EQ(ozone_filter_yapo_cutler(nanometres(600), 0), 1);
}

// What makes the rim turquoise: blue passes, orange does not.
TEST(OzoneFilter, PassesBlueAndStopsOrange) {
  EXPECT_GT(ozone_filter_yapo_cutler(nanometres(450), 300), 0.95);
  EXPECT_LT(ozone_filter_yapo_cutler(nanometres(600), 300), 0.4);
}

TEST(OzoneFilter, RefusesColumnsOutsideItsRange) {
  EXPECT_NO_THROW(ozone_filter_yapo_cutler(nanometres(600), 1000));
  EXPECT_THROW(ozone_filter_yapo_cutler(nanometres(600), -1), algebra::Error);
  EXPECT_THROW(ozone_filter_yapo_cutler(nanometres(600), 1001), algebra::Error);
  EXPECT_THROW(ozone_filter_yapo_cutler(nanometres(300), 300), algebra::Error);
}

}  // namespace
}  // namespace coppermoon::atmosphere
