// SPDX-License-Identifier: MIT
#include "atmosphere/observer_air.h"

#include "atmosphere/air_mass.h"
#include "atmosphere/ozone.h"
#include "support/testing.h"

namespace coppermoon::atmosphere::observer_air_test {

using algebra::degrees;
using algebra::nanometres;

constexpr const char* rounding = "rounding of doubles";
constexpr ObserverAir molecules{.ozone_du = 0, .aerosol_optical_depth = 0};

double optical_depth(const ObserverAir& air, double altitude_deg, double nm) {
  return -std::log(transmittance_above(air, degrees(altitude_deg), nanometres(nm)));
}

double magnitudes_in_zenith(const ObserverAir& air, double nm) {
  return 2.5 * std::log10(std::exp(1)) * optical_depth(air, 90, nm);
}

TEST(TransmittanceAbove, OfMoleculesIsHayesAndLathams) {
  // Hayes & Latham (1975), ApJ 197, 593: 0.0094977 c² / λ⁴ magnitudes at the zenith of the sea,
  // c = 0.23465 + 107.6 / (146 − 1/λ²) + 0.93161 / (41 − 1/λ²), λ in µm.
  const double magnitudes[][2] = {{440, 0.2661}, {550, 0.1066}, {640, 0.0576}};
  for (const auto& [nm, printed] : magnitudes)
    EXPECT_WITHIN_RELATIVE(magnitudes_in_zenith(molecules, nm), printed, 0.04,
                           "theirs are 2 to 3 % above Bucholtz");
}

TEST(TransmittanceAbove, AtTheSeaIsWhatObserversOfCometsReckonWith) {
  // Green (1992), International Comet Quarterly 14, 55: at 510 nm 0.1451 magnitudes by molecules,
  // 0.120 by aerosol, 0.016 by ozone.
  EXPECT_WITHIN(magnitudes_in_zenith({}, 510), 0.281, 0.01,
                "molecules 3 % below his, ozone for 300 DU");
}

TEST(TransmittanceAbove, OnAClearMountainIsMeasured) {
  // La Silla, 2400 m, on photometric nights: Tueg (1977), ESO Messenger 11, printed to 0.01.
  const ObserverAir la_silla{.ozone_du = 250, .aerosol_optical_depth = 0.01, .elevation_m = 2400};
  const double measured[][2] = {{440, 0.20}, {500, 0.13}, {560, 0.11}, {600, 0.09}, {640, 0.07}};
  for (const auto& [nm, magnitudes] : measured)
    EXPECT_WITHIN(magnitudes_in_zenith(la_silla, nm), magnitudes, 0.015,
                  "printed to 0.01; the aerosol was not told apart")
        << nm;
}

TEST(TransmittanceAbove, LosesRayleighScatteringWithThePressure) {
  ObserverAir mountain = molecules;
  mountain.elevation_m = 5000;
  EXPECT_WITHIN_RELATIVE(optical_depth(mountain, 30, 450) / optical_depth(molecules, 30, 450),
                         540.48 / 1013.25, 1e-3, "US 1976, printed at 5000 m: 540.48 hPa");
}

TEST(TransmittanceAbove, AddsOzoneByItsOwnAirMass) {
  ObserverAir air = molecules;
  air.ozone_du = 300;
  // By hand: 5.085e-25 m² (600 nm) × 300 × 2.6867e20 m⁻² = 0.040986
  EXPECT_WITHIN(optical_depth(air, 90, 600) - optical_depth(molecules, 90, 600), 0.040986, 1e-5,
                "the cross-section is rounded to 4 digits");
  const double low = optical_depth(air, 0, 600) - optical_depth(molecules, 0, 600);
  EXPECT_WITHIN(low / 0.040986, 12.0, 0.1, "the horizon's 12.1; the light comes from 0.5 above it");
}

TEST(TransmittanceAbove, AddsAerosolByAngstromsLaw) {
  ObserverAir air = molecules;
  air.aerosol_optical_depth = 0.2;
  EXPECT_WITHIN(optical_depth(air, 90, 550) - optical_depth(molecules, 90, 550), 0.2, 1e-12,
                rounding);
  EXPECT_WITHIN(optical_depth(air, 90, 440) - optical_depth(molecules, 90, 440),
                0.2 * std::pow(1.25, 1.3), 1e-12, rounding);
  air.angstrom_exponent = 0;
  EXPECT_WITHIN(optical_depth(air, 90, 700) - optical_depth(molecules, 90, 700), 0.2, 1e-12,
                rounding);
}

TEST(TransmittanceAbove, FallsTowardsTheHorizonAndIsHeldBelowIt) {
  for (const double nm : {380.0, 550.0, 780.0}) {
    for (double altitude = -0.5; altitude < 90; altitude += 0.25)
      EXPECT_GT(transmittance_above({}, degrees(altitude + 0.25), nanometres(nm)),
                transmittance_above({}, degrees(altitude), nanometres(nm)))
          << altitude << " degrees, " << nm << " nm";
    EXPECT_WITHIN_RELATIVE(optical_depth({}, -1, nm), optical_depth({}, -0.5739, nm), 1e-4,
                           "the horizon's altitude is given to 4 decimals");
  }
}

TEST(TransmittanceAbove, IsANumberBetweenNothingAndAllEverywhere) {
  ObserverAir thick{.ozone_du = 1000, .aerosol_optical_depth = 10, .elevation_m = -500};
  ObserverAir thin{.ozone_du = 0, .aerosol_optical_depth = 0, .elevation_m = 1e5};
  for (const auto& air : {thick, thin, ObserverAir{}})
    for (const double altitude : {-1.0, -0.5739, 0.0, 90.0})
      for (const double nm : {380.0, 550.0, 780.0}) {
        const double passed = transmittance_above(air, degrees(altitude), nanometres(nm));
        EXPECT_TRUE(passed >= 0 && passed <= 1) << altitude << " " << nm << " " << passed;
      }
  EXPECT_WITHIN(transmittance_above(thin, degrees(0), nanometres(550)), 1, 1e-5,
                "2e-7 of the air is left at 100 km");
}

TEST(TransmittanceAbove, RefusesAirThatIsNone) {
  const auto refuses = [](const ObserverAir& air) {
    EXPECT_THROW(transmittance_above(air, degrees(45), nanometres(550)), algebra::Error);
  };
  refuses({.ozone_du = -1});
  refuses({.ozone_du = 1001});
  refuses({.aerosol_optical_depth = -0.1});
  refuses({.aerosol_optical_depth = std::nan("")});
  refuses({.angstrom_exponent = 5});
  refuses({.elevation_m = 1.1e5});
  EXPECT_THROW(transmittance_above({}, degrees(-1.1), nanometres(550)), algebra::Error);
  EXPECT_THROW(transmittance_above({}, degrees(45), nanometres(300)), algebra::Error);
}

TEST(PressureRatio, IsPrintedInTheStandardAtmosphere) {
  // U.S. Standard Atmosphere 1976, table I, geometric altitude, over 1013.25 hPa.
  const double printed[][3] = {{0, 1013.25, 1e-9},    {1000, 898.76, 3e-3},  {5000, 540.48, 3e-3},
                               {11000, 226.99, 4e-3}, {20000, 55.293, 0.02}, {30000, 11.970, 0.06}};
  for (const auto& [elevation_m, hpa, tolerance] : printed)
    EXPECT_WITHIN_RELATIVE(pressure_ratio_us_1976(elevation_m), hpa / 1013.25, tolerance,
                           "geometric for geopotential altitude; warmer above 20 km");
}

}  // namespace coppermoon::atmosphere::observer_air_test
