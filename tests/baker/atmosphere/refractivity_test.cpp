// SPDX-License-Identifier: MIT
#include "atmosphere/refractivity.h"

#include "baker/atmosphere/published_table.h"
#include "support/testing.h"

namespace coppermoon::atmosphere::refractivity_test {

using algebra::nanometres;

const auto ciddor = published_table("baker/atmosphere/data/refractivity_ciddor_1996.csv");

double below_ciddor(std::size_t i) {
  const double reference = ciddor["refractivity_e8"][i] * 1e-8;
  return 1 - sea_level_refractivity_crc(nanometres(ciddor["wavelength_nm"][i])) / reference;
}

TEST(SeaLevelRefractivityCrc, LiesBelowCiddorByWhatItsDocumentationStates) {
  const auto last = ciddor["wavelength_nm"].size() - 1;
  EXPECT_WITHIN(below_ciddor(0), 0.0038, 5e-5, "0.38 % at 380 nm, stated to two digits");
  EXPECT_WITHIN(below_ciddor(last), 0.0015, 5e-5, "0.15 % at 780 nm, stated to two digits");
  for (std::size_t i = 1; i <= last; ++i) {
    EXPECT_LT(below_ciddor(i), below_ciddor(i - 1)) << ciddor["wavelength_nm"][i] << " nm";
  }
}

TEST(SeaLevelRefractivityCrc, HasTheFigureItsDocumentationStates) {
  EXPECT_WITHIN(sea_level_refractivity_crc(nanometres(550)), 2.770936e-4, 5.5e-11,
                "stated to 7 digits");
}

// A misprint of the dispersion's coefficient by ten shows here: it leaves a quarter.
TEST(SeaLevelRefractivityCrc, DispersesAsCiddorDoes) {
  const auto &nm = ciddor["wavelength_nm"], &n = ciddor["refractivity_e8"];
  ASSERT_EQ(nm[1], 400);
  ASSERT_EQ(nm[16], 700);
  const double dispersion =
      sea_level_refractivity_crc(nanometres(400)) - sea_level_refractivity_crc(nanometres(700));
  EXPECT_WITHIN_RELATIVE(dispersion, (n[1] - n[16]) * 1e-8, 0.08, "the handbook's data of 1919");
}

TEST(SeaLevelRefractivityCrc, RefusesWavelengthsOutsideItsRange) {
  EXPECT_NO_THROW(sea_level_refractivity_crc(nanometres(380)));
  EXPECT_NO_THROW(sea_level_refractivity_crc(nanometres(780)));
  EXPECT_THROW(sea_level_refractivity_crc(nanometres(379.99)), algebra::Error);
  EXPECT_THROW(sea_level_refractivity_crc(nanometres(780.01)), algebra::Error);
  EXPECT_THROW(sea_level_refractivity_crc(nanometres(std::numeric_limits<double>::quiet_NaN())),
               algebra::Error);
}

TEST(SeaLevelRefractivityCiddor, IsThatOfThePublishedFormula) {
  for (std::size_t i = 0; i < ciddor["wavelength_nm"].size(); ++i)
    EXPECT_WITHIN(sea_level_refractivity_ciddor_1996(nanometres(ciddor["wavelength_nm"][i])),
                  ciddor["refractivity_e8"][i] * 1e-8, 6e-12, "tabulated to 1e-11")
        << ciddor["wavelength_nm"][i] << " nm";
}

TEST(SeaLevelRefractivityCiddor, LiesAbovePeckAndReederByWhatItsDocumentationStates) {
  for (double nm = 380; nm <= 780; nm += 10) {
    const double s_squared = 1e6 / (nm * nm);
    const double four_terms =
        8060.51 + 2480990 / (132.274 - s_squared) + 17455.7 / (39.32957 - s_squared);
    const double above = sea_level_refractivity_ciddor_1996(nanometres(nm)) * 1e8 / four_terms - 1;
    EXPECT_WITHIN(above, 5e-5, 1e-5, "stated as at most 6e-5: 450 for 330 ppm of carbon dioxide")
        << nm << " nm";
  }
}

TEST(SeaLevelRefractivityCiddor, HasTheFigureItsDocumentationStates) {
  EXPECT_WITHIN(sea_level_refractivity_ciddor_1996(nanometres(550)), 2.778376e-4, 5.5e-11,
                "stated to 7 digits");
}

TEST(SeaLevelRefractivityCiddor, RefusesWavelengthsOutsideItsRange) {
  EXPECT_THROW(sea_level_refractivity_ciddor_1996(nanometres(379.99)), algebra::Error);
  EXPECT_THROW(sea_level_refractivity_ciddor_1996(nanometres(780.01)), algebra::Error);
}

}  // namespace coppermoon::atmosphere::refractivity_test
