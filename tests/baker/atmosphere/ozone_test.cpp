// SPDX-License-Identifier: MIT
#include "atmosphere/ozone.h"

#include "baker/atmosphere/published_table.h"
#include "support/testing.h"

namespace coppermoon::atmosphere::ozone_test {

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

// McPeters, Labow & Logan (2007): 436 DU over 85° N in March, 149 over 85° S in October.
TEST(OzoneClimate, HasThePublishedColumns) {
  const auto column = [](double latitude, double month) {
    const double year = 2001 + (month - 0.5) / 12;
    return OzoneClimate(algebra::degrees(latitude), year, {algebra::degrees(latitude), year})
        .column_du();
  };
  EXPECT_WITHIN_RELATIVE(column(85, 3), 436, 0.04,
                         "theirs are of whole profiles, these of whole km");
  EXPECT_WITHIN_RELATIVE(column(-85, 10), 149, 0.04, "the same");
  EXPECT_WITHIN(column(5, 1), 258, 12, "the tropics' 250 to 270");
  EXPECT_WITHIN(column(85, 3.5), (column(85, 3) + column(85, 4)) / 2, 1e-6, "straight in time");
  EXPECT_WITHIN(column(0, 12.999), column(0, 1), 0.5, "December runs into January, a day apart");
}

TEST(OzoneClimate, SpreadsItsColumnOverAltitude) {
  for (const double latitude : {-80., 0., 60.}) {
    const SeasonalAir air(algebra::degrees(latitude), 2001.2);
    const OzoneClimate ozone(algebra::degrees(latitude), 2001.2, air);
    double sum = 0, peak = 0, peak_m = 0;
    for (double h = 10; h < 86e3; h += 20) {
      const double here = ozone.profile_per_m(h);
      sum += 20 * here;
      if (here > peak) peak = here, peak_m = h;
    }
    EXPECT_WITHIN(sum, 1, 1e-5, "midpoints of 20 m of layers of 2 km");
    EXPECT_WITHIN(peak_m, latitude == 0 ? 26e3 : 19e3, 3e3,
                  "high in the tropics, low at the poles");
    EXPECT_EQ(ozone.profile_per_m(86.1e3), 0);
  }
}

// Molecules per m³ of the standard's table 18.
TEST(OzoneProfile, TimesTheStandardsColumnIsTheStandardsDensity) {
  const double column_per_m2 = 345 * dobson_unit_per_m2;
  const auto density = [&](double km) { return column_per_m2 * ozone_profile_per_m(km * 1e3); };
  for (const auto& [km, printed] : {std::pair{2.0, 6.8e17},
                                    {10.0, 1.13e18},
                                    {16.0, 2.95e18},
                                    {22.0, 4.86e18},
                                    {30.0, 2.52e18},
                                    {40.0, 6.07e17},
                                    {50.0, 6.64e16},
                                    {60.0, 7.33e15},
                                    {74.0, 1.7e14}})
    EXPECT_WITHIN_RELATIVE(density(km), printed, 0.0075, "345 DU stated, 347 in the table")
        << km << " km";
}

TEST(OzoneProfile, HasTheColumnOfTheStandard) {
  const double column_du = 4.86e18 / ozone_profile_per_m(22e3) / dobson_unit_per_m2;
  EXPECT_WITHIN(column_du, 345.0, 5,
                "trapezia over its table give 343 to 350 DU, with the air below 2 km");
  EXPECT_WITHIN(column_du, 347.0, 0.5, "stated to 1 DU");
}

TEST(OzoneProfile, IsAShareOfTheColumn) {
  double sum = 0;
  for (double h = 1; h < 86e3; h += 2) sum += 2 * ozone_profile_per_m(h);
  EXPECT_WITHIN(sum, 1.0, 1e-6, "midpoints of 2 m");
}

TEST(OzoneProfile, PeaksAt22KilometresWithTheFigureItsDocumentationStates) {
  double peak_m = 0;
  for (double h = 0; h < 86e3; h += 100)
    if (ozone_profile_per_m(h) > ozone_profile_per_m(peak_m)) peak_m = h;
  EXPECT_WITHIN(peak_m, 22e3, 100.0, "step of the search");
  EXPECT_WITHIN(ozone_profile_per_m(22e3), 5.2e-5, 0.05e-5, "stated to 2 digits");
}

TEST(OzoneProfile, IsHeldBelow2KilometresAndNothingAboveTheAir) {
  for (const double h : {-500.0, 0.0, 700.0, 1999.0})
    EXPECT_WITHIN_RELATIVE(ozone_profile_per_m(h), ozone_profile_per_m(2e3), 1e-14, "rounding");
  EXPECT_GT(ozone_profile_per_m(85.9e3), 0);
  EXPECT_EQ(ozone_profile_per_m(86.1e3), 0);
}

double log_slope(double altitude_m) {
  return std::log(ozone_profile_per_m(altitude_m + 0.1) / ozone_profile_per_m(altitude_m - 0.1)) /
         0.2;
}

TEST(OzoneProfile, HasASlopeWithoutJumps) {
  for (double h = 1e3; h < 85e3; h += 500)
    EXPECT_WITHIN(log_slope(h + 1), log_slope(h - 1), 2e-6,
                  "1/100 of the slopes, 2e-4 per metre; a kink would be of their order")
        << h << " m";
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

}  // namespace coppermoon::atmosphere::ozone_test
