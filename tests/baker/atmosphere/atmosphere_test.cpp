// SPDX-License-Identifier: MIT
#include "atmosphere/atmosphere.h"

#include <gtest/gtest.h>

#include <string>

#include "algebra/error.h"
#include "atmosphere/density.h"
#include "atmosphere/rayleigh.h"
#include "baker/atmosphere/published_table.h"
#include "support/within.h"

namespace coppermoon::atmosphere {
namespace {

using algebra::degrees;
using algebra::in_radians;
using algebra::nanometres;

const Optics green = sea_level_optics(nanometres(550));

TEST(SeaLevelOptics, HoldsTheAirOfOneWavelength) {
  EXPECT_WITHIN(green.refractivity, 2.7709365e-4, 5e-12, "the formula by hand to 8 digits");
  EXPECT_WITHIN_RELATIVE(green.rayleigh_per_m, 1.1487e-5, 0.005,
                         "Bucholtz (1995), whose cross-section is 0.4 % larger");
  EXPECT_EQ(green.wavelength_nm, 550);
  EXPECT_THROW(sea_level_optics(nanometres(379)), algebra::Error);
  EXPECT_THROW(sea_level_optics(nanometres(781)), algebra::Error);
}

TEST(Refractivity, IsProportionalToDensity) {
  for (double h = 0; h < 45e3; h += 1500)
    EXPECT_WITHIN(refractivity({}, green, h), green.refractivity * density_ratio_yapo_cutler(h),
                  1e-19, "rounding");
}

TEST(Refractivity, CanBeSwitchedOff) {
  EXPECT_EQ(refractivity({.refraction = false}, green, 0), 0);
}

TEST(Extinction, OfClearAirIsProportionalToDensity) {
  for (double h = 0; h < 45e3; h += 1500)
    EXPECT_WITHIN(extinction_per_m({}, green, h),
                  green.rayleigh_per_m * density_ratio_yapo_cutler(h), 1e-20, "rounding");
  EXPECT_EQ(extinction_per_m({.rayleigh = false}, green, 0), 0);
}

TEST(Extinction, OfDustIsGreyInsideItsLayerOnly) {
  const Column dusty{.rayleigh = false, .dust_extinction_per_m = 4.7e-6};
  EXPECT_EQ(extinction_per_m(dusty, green, 14999), 0);
  EXPECT_EQ(extinction_per_m(dusty, green, 15000), 4.7e-6);
  EXPECT_EQ(extinction_per_m(dusty, sea_level_optics(nanometres(700)), 19999), 4.7e-6);
  EXPECT_EQ(extinction_per_m(dusty, green, 20000), 0);
  const Column both{.dust_extinction_per_m = 4.7e-6};
  EXPECT_WITHIN(extinction_per_m(both, green, 17e3), 4.7e-6 + extinction_per_m({}, green, 17e3),
                1e-20, "they add");
}

TEST(OzoneTransmittance, IsOneWithoutOzone) {
  EXPECT_EQ(ozone_transmittance({}, green), 1);
  EXPECT_LT(ozone_transmittance({.ozone_du = 300}, green), 0.6);
}

// Simpson's rule over the number densities of the standard up to 36 km, the cross-section that of
// one molecule; from there to 42 km, trapezia, on the ramp with ⅔ and ⅓.
TEST(VerticalRayleighOpticalDepth, CountsTheMoleculesOfTheStandardAtmosphere) {
  const auto levels = published_table("baker/atmosphere/data/us_standard_1976_levels.csv");
  const auto& n = levels["number_density_per_m3"];
  double column = 0;  // [m⁻³ km]
  for (std::size_t i = 0; i < 18; i += 2) column += (n[i] + 4 * n[i + 1] + n[i + 2]) * 2 / 3;
  column += n[18] + n[19];
  const double at_39_km = 9.61975e22, at_40_km = n[20] * 2 / 3, at_41_km = 7.18643e22 / 3;
  column +=
      (n[19] + at_39_km) / 2 + (at_39_km + at_40_km) / 2 + (at_40_km + at_41_km) / 2 + at_41_km / 2;
  const double section_m2 = rayleigh_cross_section_m2(nanometres(550));
  EXPECT_WITHIN_RELATIVE(vertical_rayleigh_optical_depth(green), section_m2 * column * 1e3, 1e-3,
                         "Simpson's rule on steps of 2 km across the tropopause");
}

// Bodhaine et al. (1999), J. Atmos. Oceanic Technol. 16, 1854, Eq. 30: sea level, latitude 45°.
double bodhaine(double um) {
  const double s = um * um;
  return 0.0021520 * (1.0455996 - 341.29061 / s - 0.90230850 * s) /
         (1 + 0.0027059889 / s - 85.968563 * s);
}

TEST(VerticalRayleighOpticalDepth, IsThePublishedOneOfTheWholeAtmosphere) {
  for (const double nm : {400.0, 550.0, 700.0})
    EXPECT_WITHIN_RELATIVE(
        vertical_rayleigh_optical_depth(sea_level_optics(nanometres(nm))), bodhaine(nm / 1e3),
        0.011,
        "0.1 to 0.8 % less cross-section; 0.3 % of the air is cut, 0.2 % is the fall of gravity");
}

std::string refused(const Atmosphere& atmosphere) {
  try {
    require_valid(atmosphere);
  } catch (const algebra::Error& error) {
    return error.what();
  }
  return "";
}

TEST(RequireValid, LetsTheDefaultsAndTheEndsOfTheRangesPass) {
  EXPECT_EQ(refused({}), "");
  EXPECT_EQ(refused({.column = {.ozone_du = 1000, .dust_extinction_per_m = 0.01}}), "");
  EXPECT_EQ(refused({.column = {.dust_bottom_m = 0, .dust_top_m = 42e3}}), "");
}

TEST(RequireValid, NamesTheTermItsUnitAndWhatIsAllowed) {
  EXPECT_EQ(refused({.column = {.ozone_du = -1}}), "ozone [DU] = -1, allowed 0 to 1000");
  EXPECT_EQ(refused({.column = {.dust_extinction_per_m = 2}}),
            "dust extinction [1/m] = 2, allowed 0 to 0.01");
  EXPECT_EQ(refused({.column = {.dust_bottom_m = -1}}), "dust bottom [m] = -1, allowed 0 to 42000");
  EXPECT_EQ(refused({.column = {.dust_top_m = 14e3}}),
            "dust top [m] = 14000, allowed 15000 to 42000");
}

TEST(RequireValid, LooksAtTheEarthItself) {
  EXPECT_EQ(refused({.top_m = -1}), "top of the air [m] = -1, allowed 0 to 42000");
  EXPECT_EQ(refused({.earth_radius_m = 0}), "Earth's radius [m] = 0, allowed 1e+06 to 1e+07");
}

TEST(ColumnAt, OfAWholeTurnIsTheRegionEverywhere) {
  Atmosphere dusty;
  dusty.regions.push_back({algebra::degrees(0), algebra::degrees(360), {.ozone_du = 7}});
  for (const double turn : {0.0, 1.0, 3.2, 6.2}) EXPECT_EQ(dusty.column_at(turn).ozone_du, 7);
}

TEST(RequireValid, LooksIntoTheRegions) {
  EXPECT_EQ(refused({.regions = {{degrees(0), degrees(90), {.ozone_du = 2000}}}}),
            "ozone [DU] = 2000, allowed 0 to 1000");
}

double ozone_at(const Atmosphere& atmosphere, double position_angle_deg) {
  return atmosphere.column_at(in_radians(degrees(position_angle_deg))).ozone_du;
}

TEST(ColumnAt, IsTheRegionThatHoldsThePositionAngle) {
  const Atmosphere atmosphere{.column = {.ozone_du = 300},
                              .regions = {{degrees(80), degrees(100), {.ozone_du = 100}}}};
  EXPECT_FALSE(atmosphere.symmetric());
  EXPECT_EQ(ozone_at(atmosphere, 79.9), 300);
  EXPECT_EQ(ozone_at(atmosphere, 80.1), 100);
  EXPECT_EQ(ozone_at(atmosphere, 99.9), 100);
  EXPECT_EQ(ozone_at(atmosphere, 100.1), 300);
}

TEST(ColumnAt, TurnsThroughNorthAndWholeCircles) {
  const Atmosphere atmosphere{.column = {.ozone_du = 300},
                              .regions = {{degrees(350), degrees(10), {.ozone_du = 100}}}};
  for (const double angle : {-5.0, 0.0, 5.0, 355.0, 365.0, 715.0})
    EXPECT_EQ(ozone_at(atmosphere, angle), 100) << angle;
  for (const double angle : {-15.0, 15.0, 180.0, 345.0, 735.0})
    EXPECT_EQ(ozone_at(atmosphere, angle), 300) << angle;
}

TEST(ColumnAt, TakesTheFirstOfOverlappingRegions) {
  const Atmosphere atmosphere{.regions = {{degrees(0), degrees(90), {.ozone_du = 1}},
                                          {degrees(45), degrees(180), {.ozone_du = 2}}}};
  EXPECT_EQ(ozone_at(atmosphere, 60), 1);
  EXPECT_EQ(ozone_at(atmosphere, 120), 2);
}

TEST(Atmosphere, OfTheDefaultsIsThePapersSphere) {
  EXPECT_TRUE(Atmosphere{}.symmetric());
  EXPECT_EQ(Atmosphere{}.top_radius_m(), 6.42e6);
}

}  // namespace
}  // namespace coppermoon::atmosphere
