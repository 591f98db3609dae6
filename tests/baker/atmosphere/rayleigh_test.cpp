// SPDX-License-Identifier: MIT
#include "atmosphere/rayleigh.h"

#include "atmosphere/refractivity.h"
#include "baker/atmosphere/published_table.h"
#include "support/testing.h"

namespace coppermoon::atmosphere::rayleigh_test {

using algebra::nanometres;

const auto bucholtz = published_table("baker/atmosphere/data/rayleigh_bucholtz_1995.csv");

double below_bucholtz(std::size_t i) {
  return 1 - rayleigh_cross_section_m2(nanometres(bucholtz["wavelength_nm"][i])) /
                 bucholtz["cross_section_m2"][i];
}

TEST(RayleighCrossSection, LiesBelowBucholtzByWhatItsDocumentationStates) {
  const auto last = bucholtz["wavelength_nm"].size() - 1;
  EXPECT_WITHIN(below_bucholtz(0), 0.0081, 5e-5, "0.81 % at 380 nm, stated to two digits");
  EXPECT_WITHIN(below_bucholtz(last), 0.0001, 5e-5, "0.01 % at 780 nm, stated to one digit");
  for (std::size_t i = 0; i <= last; ++i) {
    EXPECT_GT(below_bucholtz(i), 0) << bucholtz["wavelength_nm"][i] << " nm";
    EXPECT_LT(below_bucholtz(i), 0.0085) << bucholtz["wavelength_nm"][i] << " nm";
  }
}

TEST(RayleighCrossSection, HasTheFigureItsDocumentationStates) {
  EXPECT_WITHIN(rayleigh_cross_section_m2(nanometres(550)), 4.491e-31, 5e-35, "stated to 4 digits");
}

// Bucholtz counts 2.54743e25 molecules, the standard atmosphere 2.546972e25: 0.02 % more.
TEST(RayleighCrossSection, TimesTheMoleculesIsTheScatteringOfSeaLevelAir) {
  for (std::size_t i = 0; i < bucholtz["wavelength_nm"].size(); ++i)
    EXPECT_WITHIN_RELATIVE(rayleigh_cross_section_m2(nanometres(bucholtz["wavelength_nm"][i])) *
                               sea_level_number_density_per_m3,
                           bucholtz["scattering_per_m"][i], 0.0085,
                           "0.81 % of cross-section, 0.02 % of density");
}

TEST(RayleighCrossSection, RefusesWavelengthsOutsideItsRange) {
  EXPECT_THROW(rayleigh_cross_section_m2(nanometres(379.99)), algebra::Error);
  EXPECT_THROW(rayleigh_cross_section_m2(nanometres(780.01)), algebra::Error);
}

double best_over_bucholtz(std::size_t i) {
  const auto wavelength = nanometres(bucholtz["wavelength_nm"][i]);
  return rayleigh_cross_section_m2(sea_level_refractivity_ciddor_1996(wavelength),
                                   king_factor_bates_1984(wavelength), wavelength) /
         bucholtz["cross_section_m2"][i];
}

TEST(RayleighCrossSection, OfModernAirLiesAboveBucholtzByWhatItsDocumentationStates) {
  EXPECT_WITHIN(best_over_bucholtz(0), 1.0013, 5e-5, "0.13 % at 380 nm, Bucholtz to 5 digits");
  for (std::size_t i = 0; i < bucholtz["wavelength_nm"].size(); ++i) {
    EXPECT_GT(best_over_bucholtz(i), 1.00025) << bucholtz["wavelength_nm"][i] << " nm";
    EXPECT_LT(best_over_bucholtz(i), 1.0013) << bucholtz["wavelength_nm"][i] << " nm";
  }
}

TEST(RayleighCrossSection, IsProportionalToTheKingFactor) {
  const auto at_550 = [](double f) {
    return rayleigh_cross_section_m2(2.77e-4, f, nanometres(550));
  };
  EXPECT_WITHIN_RELATIVE(at_550(1.05) / at_550(1), 1.05, 1e-14, "rounding");
}

TEST(KingFactor, IsThatOfThePublishedTable) {
  const auto bates = published_table("baker/atmosphere/data/king_factor_bates_1984.csv");
  for (std::size_t i = 0; i < bates["wavelength_nm"].size(); ++i)
    EXPECT_WITHIN(king_factor_bates_1984(nanometres(bates["wavelength_nm"][i])),
                  bates["king_factor"][i], 6e-6, "tabulated to 5 decimals")
        << bates["wavelength_nm"][i] << " nm";
  EXPECT_WITHIN(king_factor_bates_1984(nanometres(550)), 1.04882, 5e-6, "stated to 5 decimals");
}

TEST(KingFactor, RefusesWavelengthsOutsideItsRange) {
  EXPECT_THROW(king_factor_bates_1984(nanometres(379.99)), algebra::Error);
  EXPECT_THROW(king_factor_bates_1984(nanometres(780.01)), algebra::Error);
}

}  // namespace coppermoon::atmosphere::rayleigh_test
