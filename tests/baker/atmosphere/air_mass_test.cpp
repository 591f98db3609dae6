// SPDX-License-Identifier: MIT
#include "atmosphere/air_mass.h"

#include "algebra/error.h"
#include "support/within.h"

namespace coppermoon::atmosphere {
namespace {

TEST(AirMass, IsYoungsAtPublishedZenithDistances) {
  const double printed[][2] = {
      {0, 1.0}, {60, 1.99173}, {75, 3.79636}, {85, 10.05866}, {89, 23.45845}};
  for (const auto& [zenith_deg, mass] : printed)
    EXPECT_WITHIN(air_mass_young_1994(algebra::degrees(90 - zenith_deg)), mass, 6e-6,
                  "printed to 5 decimals");
  EXPECT_WITHIN(air_mass_young_1994(algebra::degrees(0)), 31.7, 0.05,
                "the horizon, printed to a decimal");
}

TEST(AirMass, BelowTheHorizonIsRefused) {
  EXPECT_THROW(air_mass_young_1994(algebra::degrees(-0.1)), algebra::Error);
}

}  // namespace
}  // namespace coppermoon::atmosphere
