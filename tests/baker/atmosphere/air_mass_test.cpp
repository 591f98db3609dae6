// SPDX-License-Identifier: MIT
#include "atmosphere/air_mass.h"

#include "atmosphere/astronomical_refraction.h"
#include "support/testing.h"

namespace coppermoon::atmosphere::air_mass_test {

TEST(AirMass, IsYoungsAtPublishedZenithDistances) {
  const double printed[][2] = {
      {0, 1.0}, {60, 1.99173}, {75, 3.79636}, {85, 10.05866}, {89, 23.45845}};
  for (const auto& [zenith_deg, mass] : printed)
    EXPECT_WITHIN(air_mass_young_1994(algebra::degrees(90 - zenith_deg)), mass, 6e-6,
                  "printed to 5 decimals");
  EXPECT_WITHIN(air_mass_young_1994(algebra::degrees(0)), 31.7, 0.05,
                "the horizon, printed to a decimal");
}

TEST(AirMass, OfTheApparentHorizonIsThatOfTheTablesByApparentAltitude) {
  EXPECT_WITHIN(air_mass_young_1994(lowest_true_altitude), 37.92, 0.6,
                "Kasten & Young (1989), by apparent altitude and for another atmosphere");
  EXPECT_EQ(air_mass_young_1994(algebra::degrees(-1)), air_mass_young_1994(lowest_true_altitude));
}

TEST(AirMass, BelowAllThatRefractionLiftsIsRefused) {
  EXPECT_THROW(air_mass_young_1994(algebra::degrees(-1.1)), algebra::Error);
  EXPECT_THROW(air_mass_young_1994(algebra::degrees(90.1)), algebra::Error);
}

/// ∫ exp(−h/H) ds along a straight ray over H, in steps of the altitude: s = √((R+h)² − (R cos a)²).
double integrated_air_mass(double apparent_deg, double scale_height_m) {
  const double radius_m = 6371e3,
               sine = std::sin(algebra::in_radians(algebra::degrees(apparent_deg)));
  const auto path_m = [&](double h) {
    return std::sqrt(h * (2 * radius_m + h) + radius_m * radius_m * sine * sine) - radius_m * sine;
  };
  double sum_m = 0;
  for (double root = 0; root < 200; root += 0.1) {  // h = root² crowds the steps at the ground
    const double from_m = root * root, to_m = (root + 0.1) * (root + 0.1);
    sum_m += (path_m(to_m) - path_m(from_m)) * std::exp(-(from_m + to_m) / 2 / scale_height_m);
  }
  return sum_m / scale_height_m;
}

TEST(AerosolAirMass, IsThatOfALayerWithAScaleHeightOf1500Metres) {
  for (const double altitude : {0.0, 2.0, 5.0, 10.0, 30.0, 60.0, 90.0})
    EXPECT_WITHIN_RELATIVE(aerosol_air_mass_schaefer_1993(algebra::degrees(altitude)),
                           integrated_air_mass(altitude, 1500), 0.03, "the accuracy stated")
        << altitude;
  EXPECT_WITHIN(aerosol_air_mass_schaefer_1993(algebra::degrees(0)), 1 / 0.0123, 1e-9,
                "rounding of doubles");
}

TEST(OzoneAirMass, IsThatOfAThinShell) {
  EXPECT_WITHIN(ozone_air_mass(algebra::degrees(90)), 1, 1e-12, "rounding of doubles");
  // √(R / 2h) of a parabola, for a ray that leaves along the ground.
  EXPECT_WITHIN_RELATIVE(ozone_air_mass(algebra::degrees(0)), std::sqrt(6378 / 44.0), 0.003,
                         "h / R = 0.0034");
  EXPECT_WITHIN_RELATIVE(ozone_air_mass(algebra::degrees(60)),
                         1 / std::sin(algebra::in_radians(algebra::degrees(60))), 0.002,
                         "h tan² z / R = 0.0011");
}

TEST(AirMasses, OfLayersRefuseLightFromBelowTheHorizon) {
  EXPECT_THROW(aerosol_air_mass_schaefer_1993(algebra::degrees(-0.1)), algebra::Error);
  EXPECT_THROW(ozone_air_mass(algebra::degrees(-0.1)), algebra::Error);
}

}  // namespace coppermoon::atmosphere::air_mass_test
