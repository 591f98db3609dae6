// SPDX-License-Identifier: MIT
#include "atmosphere/astronomical_refraction.h"

#include "support/testing.h"

namespace coppermoon::atmosphere::astronomical_refraction_test {

using algebra::degrees;
using algebra::in_arcminutes;
using algebra::in_degrees;

algebra::Angle arcminutes(double x) { return degrees(x / 60); }

double refraction_at(double true_altitude_deg) {
  return in_arcminutes(astronomical_refraction(degrees(true_altitude_deg)));
}

TEST(AstronomicalRefraction, IsThatOfTheTablesByApparentAltitude) {
  // Allen (1976), Astrophysical Quantities, §55: 10 degrees Celsius, 1013 hPa.
  const double printed[][2] = {{2, 18.4}, {5, 9.9}, {10, 5.3}};
  for (const auto& [apparent_deg, arcmin] : printed)
    EXPECT_WITHIN(refraction_at(apparent_deg - arcmin / 60), arcmin, 0.2,
                  "the accuracy stated from 2 degrees up");
  EXPECT_WITHIN(refraction_at(-34.5 / 60), 34.5, 1.0, "tables: 34 to 35.4 on the horizon");
}

TEST(AstronomicalRefraction, IsLaplacesFarFromTheHorizon) {
  // 58.3" tan z for air of 1010 hPa and 10 degrees Celsius, z apparent.
  for (const double apparent_deg : {30.0, 45.0, 60.0, 80.0}) {
    const double arcmin = 58.3 / 60 * std::tan(in_radians(degrees(90 - apparent_deg)));
    EXPECT_WITHIN(refraction_at(apparent_deg - arcmin / 60), arcmin, 0.1,
                  "5 %, by its rounded constants");
  }
}

TEST(AstronomicalRefraction, IsThatOfMeeusExample16a) {
  EXPECT_WITHIN(refraction_at(33.246 / 60), 24.618, 0.0025,
                "printed to 0.001; we add 0.0019 everywhere");
}

TEST(AstronomicalRefraction, VanishesInTheZenith) {
  EXPECT_WITHIN(refraction_at(90), 0, 1e-6, "the constant is given to 7 decimals");
}

TEST(AstronomicalRefraction, FallsAllTheWayUpAndIsHeldFarBelow) {
  for (double altitude = -1; altitude < 90; altitude += 0.25)
    EXPECT_GT(refraction_at(altitude), refraction_at(altitude + 0.25)) << altitude;
  EXPECT_EQ(refraction_at(-1), refraction_at(-40));
}

TEST(AstronomicalRefraction, RefusesAltitudesThatAreNone) {
  EXPECT_THROW(astronomical_refraction(degrees(90.1)), algebra::Error);
  EXPECT_THROW(astronomical_refraction(degrees(-90.1)), algebra::Error);
  EXPECT_THROW(astronomical_refraction(degrees(std::nan(""))), algebra::Error);
}

TEST(ApparentAltitude, OfWhatIsJustVisibleIsTheHorizon) {
  EXPECT_WITHIN(in_degrees(apparent_altitude(lowest_true_altitude)), 0, 5e-5,
                "given to 4 decimals");
  EXPECT_WITHIN(in_arcminutes(lowest_true_altitude), -34, 1, "the almanacs' convention: 34'");
}

TEST(ApparentAltitude, BelowTheHorizonIsTheTrueOne) {
  for (const double altitude : {-2., -12.5, -42., -90.})
    EXPECT_EQ(in_degrees(apparent_altitude(degrees(altitude))), in_degrees(degrees(altitude)));
  for (double altitude = -3; altitude < 1; altitude += 0.01)
    EXPECT_LT(in_degrees(apparent_altitude(degrees(altitude))),
              in_degrees(apparent_altitude(degrees(altitude + 0.01))))
        << "what is higher appears higher";
  EXPECT_EQ(in_degrees(apparent_altitude(degrees(-1))),
            in_degrees(degrees(-1) + astronomical_refraction(degrees(-1))));
}

TEST(RefractedFlattening, IsThatOfTheSettingSunInMeeusExample16a) {
  // The lower limb of a disc of 32' at apparent altitude 30': true limbs at 1.246' and 33.246'.
  EXPECT_WITHIN(refracted_flattening(arcminutes(17.246), arcminutes(32)), 0.871, 0.002,
                "he takes the lower limb's refraction from another formula, 0.05' away");
}

TEST(RefractedFlattening, OfASmallDiscIsTheSlopeOfTheRefraction) {
  for (const double altitude : {0.0, 3.0, 20.0}) {
    const double slope = (refraction_at(altitude + 0.01) - refraction_at(altitude - 0.01)) / 1.2;
    EXPECT_WITHIN(refracted_flattening(degrees(altitude), degrees(1e-3)), 1 + slope, 1e-5,
                  "third derivative over 0.01 degrees");
  }
}

TEST(RefractedFlattening, ShrinksADiscInTheZenithAsLaplacesFormulaDoes) {
  EXPECT_WITHIN(1 - refracted_flattening(degrees(90), degrees(0.52)), 58.3 / 206265, 3e-5,
                "Saemundsson's slope there is 5 % off");
}

TEST(RefractedFlattening, HasTheFiguresItsDocumentationStates) {
  EXPECT_WITHIN(refracted_flattening(lowest_true_altitude, degrees(0.52)), 0.83, 0.005, "2 digits");
  EXPECT_WITHIN(refracted_flattening(degrees(0.29), degrees(0.52)), 0.87, 0.005, "2 digits");
  EXPECT_WITHIN(refracted_flattening(degrees(90), degrees(0.52)), 0.9997, 5e-5, "4 digits");
}

TEST(RefractedFlattening, RefusesWhatIsNoDisc) {
  EXPECT_THROW(refracted_flattening(degrees(10), degrees(0)), algebra::Error);
  EXPECT_THROW(refracted_flattening(degrees(91), degrees(0.5)), algebra::Error);
}

}  // namespace coppermoon::atmosphere::astronomical_refraction_test
