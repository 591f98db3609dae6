// SPDX-License-Identifier: MIT
#include "atmosphere/gases.h"

#include <gtest/gtest.h>

#include "algebra/error.h"
#include "support/within.h"

namespace coppermoon::atmosphere {
namespace {

using algebra::nanometres;

// Greenblatt et al. (1990), J. Geophys. Res. 95, 18577, at 296 K: peak [1e-46 cm⁵] and width [nm] of each
// band; its area is their product, here the sum over the band in steps of 1 nm.
TEST(OxygenPairs, HaveTheBandsOfAnotherMeasurement) {
  struct Band {
    double centre_nm, peak, width_nm;
  };
  for (const auto& [centre, peak, width] : {Band{577.2, 11.0, 11.6}, Band{630.0, 7.2, 13.8}}) {
    double area = 0;
    for (double nm = centre - 25; nm <= centre + 25; nm += 1)
      area += oxygen_pair_cross_section_m5(nanometres(nm)) * 1e56;
    EXPECT_WITHIN_RELATIVE(area, 1.2 * peak * width, 0.2,
                           "a band of that width has 1.06 (Gauss) to 1.57 (Lorentz) of the product")
        << centre;
  }
  EXPECT_EQ(oxygen_pair_cross_section_m5(nanometres(700)), 0);
  EXPECT_THROW(oxygen_pair_cross_section_m5(nanometres(379)), algebra::Error);
}

// IUPAC (2003), Mérienne et al. (1995), at 298 K.
TEST(NitrogenDioxide, HasTheCrossSectionOfAnotherMeasurement) {
  EXPECT_WITHIN_RELATIVE(nitrogen_dioxide_cross_section_m2(nanometres(380)), 5.924e-23, 0.02,
                         "JPL and IUPAC agree to 1.6 % there");
  EXPECT_THROW(nitrogen_dioxide_cross_section_m2(nanometres(781)), algebra::Error);
}

// The AFGL profile's own column over the US standard atmosphere is 5.6e15 cm⁻².
TEST(NitrogenDioxide, HasTheColumnOfItsProfile) {
  double column = 0;
  for (double h = 25; h < 86e3; h += 50) column += 50 * nitrogen_dioxide_per_m3(h);
  EXPECT_WITHIN_RELATIVE(column, 5.6e19, 0.1, "of middle latitudes in summer");
}

}  // namespace
}  // namespace coppermoon::atmosphere
