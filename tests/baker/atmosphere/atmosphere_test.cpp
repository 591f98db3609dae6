// SPDX-License-Identifier: MIT
#include "atmosphere/atmosphere.h"

#include "algebra/quadrature.h"
#include "atmosphere/density.h"
#include "atmosphere/ozone.h"
#include "atmosphere/rayleigh.h"
#include "support/testing.h"

namespace coppermoon::atmosphere::atmosphere_test {

using algebra::degrees;
using algebra::in_degrees;
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

TEST(LimbFilter, IsOneWithoutOzoneAndCloud) {
  EXPECT_EQ(limb_filter({}, green, 0), 1);
  EXPECT_LT(limb_filter({.ozone_du = 300}, green, 20e3), 0.6);
  EXPECT_EQ(limb_filter({.ozone_du = 300, .ozone_path = OzonePath::bent}, green, 20e3), 1);
}

TEST(LimbFilter, OfCloudIsWhatItLeavesUncoveredBelowItsTop) {
  const Column cloudy{.cloud_top_m = 10e3, .cloud_cover = 0.7};
  EXPECT_WITHIN(limb_filter(cloudy, green, 9999), 0.3, 1e-15, "rounding");
  EXPECT_EQ(limb_filter(cloudy, green, 10000), 1);
}

TEST(Extinction, IsTheSumOfAllThatStandsThere) {
  const Column full{.density = Density::us_1976,
                    .ozone_du = 300,
                    .ozone_path = OzonePath::bent,
                    .dust_extinction_per_m = 1e-6,
                    .tropospheric_optical_depth = 0.1,
                    .stratosphere = StratosphericAerosol::high};
  const auto red = sea_level_optics(nanometres(650));
  for (const double h : {1e3, 9.7e3, 17e3, 25e3, 60e3}) {
    const double sum =
        red.rayleigh_per_m * density_ratio_us_1976(h) +
        300 * dobson_unit_per_m2 * ozone_cross_section_m2(nanometres(650)) *
            ozone_profile_per_m(h) +
        (h > 15e3 && h < 20e3 ? 1e-6 : 0) +
        0.1 * tropospheric_profile_per_m(2e3, h) * tropospheric_spectrum(nanometres(650)) +
        stratospheric_extinction_per_m(StratosphericAerosol::high, h) *
            stratospheric_spectrum(StratosphericAerosol::high, nanometres(650));
    EXPECT_WITHIN_RELATIVE(extinction_per_m(full, red, h), sum, 1e-14, "rounding");
  }
}

TEST(SeaLevelOptics, OfOtherMoleculesAreThoseOfTheirModels) {
  const auto other = sea_level_optics(nanometres(450), {.dispersion = Dispersion::ciddor_1996,
                                                        .king_factor = KingFactor::bates_1984});
  EXPECT_WITHIN_RELATIVE(other.refractivity, 28053.336e-8, 1e-7, "Ciddor (1996), 8 digits");
  EXPECT_WITHIN_RELATIVE(other.rayleigh_per_m, 1.0268e-30 * sea_level_number_density_per_m3, 1.5e-3,
                         "Bucholtz (1995), whose refractivity and F are another's");
}

// Hydrostatics: the column is p₀ N_A / (g M), of air whose mean height is 8.4 km, where g is
// 1 − 2 h/R of that at sea level.
TEST(VerticalRayleighOpticalDepth, CountsTheMoleculesThatThePressureCarries) {
  const double at_sea_level = 101325 * 6.022169e23 / (9.80665 * 28.9644e-3);
  const double column = at_sea_level * (1 + 2 * 7.2e3 / 6.357e6);  // mean height over pressure
  EXPECT_WITHIN_RELATIVE(vertical_rayleigh_optical_depth(green),
                         rayleigh_cross_section_m2(nanometres(550)) * column, 5e-4,
                         "the mean height of the air is known to a kilometre");
}

// Bodhaine et al. (1999), J. Atmos. Oceanic Technol. 16, 1854, Eq. 30: sea level, latitude 45°.
double bodhaine(double um) {
  const double s = um * um;
  return 0.0021520 * (1.0455996 - 341.29061 / s - 0.90230850 * s) /
         (1 + 0.0027059889 / s - 85.968563 * s);
}

TEST(VerticalRayleighOpticalDepth, IsThePublishedOneOfTheWholeAtmosphere) {
  for (const double nm : {400.0, 550.0, 700.0})
    EXPECT_WITHIN_RELATIVE(vertical_rayleigh_optical_depth(sea_level_optics(nanometres(nm))),
                           bodhaine(nm / 1e3), 0.009,
                           "0.1 to 0.8 % less cross-section; 0.2 % is the fall of gravity");
}

std::string refusal(const Atmosphere& atmosphere) {
  return refusal_of([&] { require_valid(atmosphere); });
}

TEST(RequireValid, LetsTheDefaultsAndTheEndsOfTheRangesPass) {
  EXPECT_EQ(refusal({}), "");
  EXPECT_EQ(refusal({.column = {.ozone_du = 1000, .dust_extinction_per_m = 0.01}}), "");
  EXPECT_EQ(refusal({.column = {.dust_bottom_m = 0, .dust_top_m = 42e3}}), "");
}

TEST(RequireValid, NamesTheTermItsUnitAndWhatIsAllowed) {
  EXPECT_EQ(refusal({.column = {.ozone_du = -1}}), "ozone [DU] = -1, allowed 0 to 1000");
  EXPECT_EQ(refusal({.column = {.dust_extinction_per_m = 2}}),
            "dust extinction [1/m] = 2, allowed 0 to 0.01");
  EXPECT_EQ(refusal({.column = {.dust_bottom_m = -1}}),
            "dust bottom [km] = -0.001, allowed 0 to 86");
  EXPECT_EQ(refusal({.column = {.dust_top_m = 14e3}}), "dust top [km] = 14, allowed 15 to 86");
  EXPECT_EQ(refusal({.column = {.tropospheric_optical_depth = -1}}),
            "tropospheric optical depth = -1, allowed 0 to 10");
  EXPECT_EQ(refusal({.column = {.cloud_top_m = 31e3}}), "cloud top [km] = 31, allowed 0 to 30");
  EXPECT_EQ(refusal({.column = {.cloud_cover = 70}}), "cloud cover = 70, allowed 0 to 1");
}

TEST(RequireValid, LooksAtTheEarthItself) {
  EXPECT_EQ(refusal({.earth = {.equatorial_radius_m = 0}}),
            "Earth's radius [m] = 0, allowed 1e+06 to 1e+07");
  EXPECT_EQ(refusal({.earth = {.polar_radius_m = 1}}),
            "Earth's polar radius [m] = 1, allowed 5.7402e+06 to 7.0158e+06");
}

TEST(ColumnAt, OfAWholeTurnIsTheRegionEverywhere) {
  Atmosphere dusty;
  dusty.regions.push_back({algebra::degrees(0), algebra::degrees(360), {.ozone_du = 7}});
  for (const double turn : {0.0, 1.0, 3.2, 6.2})
    EXPECT_EQ(dusty.columns()[dusty.shares_at(turn)[0].column]->ozone_du, 7);
}

TEST(SharesAt, OfBeltsAreStraightFromOneToTheNextAndAlikeToEastAndWest) {
  Atmosphere air;
  air.belts = {{0.5, {}}, {1.5, {}}, {2.5, {}}};
  air.regions = {{algebra::radians(4), algebra::radians(5), {}}};
  ASSERT_EQ(air.columns().size(), 4U);
  for (const double sign : {1., -1.}) {
    const auto [one, other] = air.shares_at(sign * 0.75);
    EXPECT_EQ(one.column, 0U);
    EXPECT_EQ(other.column, 1U);
    EXPECT_WITHIN(one.share, 0.75, 1e-14, "rounding");
    EXPECT_WITHIN(other.share, 0.25, 1e-14, "rounding");
  }
  EXPECT_EQ(air.shares_at(0.2)[0].share, 1);
  EXPECT_EQ(air.shares_at(3)[0].column, 2U);
  EXPECT_EQ(air.shares_at(4.5)[0].column, 3U);
  EXPECT_TRUE(air.belted());
  EXPECT_FALSE(air.symmetric());
  EXPECT_EQ(refusal({.belts = {{1, {}}, {0.5, {}}}}),
            "belt's angle from north [radians] = 0.5, allowed 1 to 3.14159");
}

TEST(RequireValid, LooksIntoTheRegions) {
  EXPECT_EQ(refusal({.regions = {{degrees(0), degrees(90), {.ozone_du = 2000}}}}),
            "ozone [DU] = 2000, allowed 0 to 1000");
}

double ozone_at(const Atmosphere& atmosphere, double position_angle_deg) {
  const auto index = atmosphere.shares_at(in_radians(degrees(position_angle_deg)))[0].column;
  return atmosphere.columns()[index]->ozone_du;
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

double width_deg(const Region& region) { return in_degrees(region.to) - in_degrees(region.from); }

TEST(BetweenLatitudes, AreTheLimbsEastAndWest) {
  const auto tropics = between_latitudes(degrees(-20), degrees(30), degrees(0), {.ozone_du = 250});
  ASSERT_TRUE(tropics);
  EXPECT_WITHIN(in_degrees(tropics->from), 60., 1e-12, "90 − 30, by definition at the equinox");
  EXPECT_WITHIN(in_degrees(tropics->to), 110., 1e-12, "90 + 20");
  EXPECT_EQ(tropics->column.ozone_du, 250);
  const Atmosphere atmosphere{.regions = {*tropics}};
  for (const double angle : {61., 109., 251., 299.}) EXPECT_EQ(ozone_at(atmosphere, angle), 250);
  for (const double angle : {0., 59., 111., 180., 249., 301.})
    EXPECT_NE(ozone_at(atmosphere, angle), 250) << angle;
  EXPECT_TRUE(atmosphere.mirrored());
}

TEST(BetweenLatitudes, GoOverThePole) {
  const auto south = between_latitudes(degrees(-90), degrees(0), degrees(10), {});
  ASSERT_TRUE(south);
  EXPECT_WITHIN(in_degrees(south->from), 90., 1e-12, "the equator, wherever the Sun");
  EXPECT_WITHIN(in_degrees(south->to), 270., 1e-12, "as above");
  const auto north = between_latitudes(degrees(60), degrees(90), degrees(0), {});
  ASSERT_TRUE(north);
  EXPECT_WITHIN(width_deg(*north), 60., 1e-12, "30 on either side");
  const auto all = between_latitudes(degrees(-90), degrees(90), degrees(-23), {});
  ASSERT_TRUE(all);
  EXPECT_WITHIN(width_deg(*all), 360., 1e-12, "all of it");
}

// The limb of a Sun at 23° reaches 67° of latitude: the ring of the terminator.
TEST(BetweenLatitudes, AreEmptyWhereTheLimbDoesNotReach) {
  EXPECT_FALSE(between_latitudes(degrees(70), degrees(80), degrees(23), {}));
  EXPECT_TRUE(between_latitudes(degrees(65), degrees(80), degrees(23), {}));
  EXPECT_THROW(between_latitudes(degrees(20), degrees(10), degrees(0), {}), algebra::Error);
  EXPECT_THROW(between_latitudes(degrees(-91), degrees(10), degrees(0), {}), algebra::Error);
}

TEST(ColumnsInUse, HaveAPartOfTheLimb) {
  const Belts belts{{0, {}}, {0.5, {}}, {1, {}}, {2, {}}, {3, {}}};
  Atmosphere atmosphere{.belts = belts};
  EXPECT_EQ(atmosphere.columns_in_use(), std::vector<bool>(5, true));
  atmosphere.regions = {{algebra::radians(0.6), algebra::radians(1.9), {}, belts, true}};
  const std::vector<bool> two_seams_inside{true,  true, true, true, true,
                                           false, true, true, true, false};
  EXPECT_EQ(atmosphere.columns_in_use(), two_seams_inside);
  atmosphere.regions[0].from = algebra::radians(-4), atmosphere.regions[0].to = degrees(180);
  const std::vector<bool> nothing_outside{false, false, false, false, false,
                                          true,  true,  true,  true,  true};
  EXPECT_EQ(atmosphere.columns_in_use(), nothing_outside);
}

/// ∫ cosᵖ χ f(χ) dΩ of what an absorber scatters.
double moment(const Column& column, Absorber absorber, int power) {
  constexpr int pieces = 200;
  double sum = 0;
  for (int i = 0; i < pieces; ++i)
    for (const auto& [x, weight] : algebra::gauss_legendre(8)) {
      const double cosine = (2 * i + 1 + x) / pieces - 1;
      sum += weight / pieces * 2 * std::numbers::pi * std::pow(cosine, power) *
             scattering(column, cosine)[absorber];
    }
  return sum;
}

TEST(Scattering, SendsOnTheAlbedoWithTheAsymmetryOfLowtran7) {
  struct Case {
    Column column;
    Absorber absorber;
    double albedo, asymmetry;
  };
  using enum StratosphericAerosol;
  for (const auto& one :
       {Case{{}, air, 1, 0}, Case{{}, dust_layer, 0.947, 0.698},
        Case{{}, troposphere, 0.963, 0.651}, Case{{}, free_troposphere, 0.963, 0.651},
        Case{{.stratosphere = background}, Absorber::stratosphere, 1, 0.685},
        Case{{.stratosphere = moderate}, Absorber::stratosphere, 0.947, 0.698},
        Case{{.stratosphere = high}, Absorber::stratosphere, 0.947, 0.698},
        Case{{.stratosphere = extreme}, Absorber::stratosphere, 0.855, 0.747},
        Case{{}, ozone, 0, 0}, Case{{}, cloud, 0, 0}, Case{{}, nitrogen_dioxide, 0, 0}}) {
    SCOPED_TRACE(one.absorber);
    EXPECT_WITHIN(moment(one.column, one.absorber, 0), one.albedo, 1e-12, "rounding");
    EXPECT_WITHIN(moment(one.column, one.absorber, 1), one.albedo * one.asymmetry, 1e-12,
                  "rounding");
  }
}

TEST(Profiles, HoldEachAbsorbersOwn) {
  const Column some{.dust_extinction_per_m = 1e-6, .cirrus = 1, .nitrogen_dioxide = true};
  for (const double h : {3e3, 9e3, 17e3, 50e3})
    for (std::size_t k = 0; k < absorbers; ++k)
      EXPECT_EQ(profiles(some, h)[k], profile(some, static_cast<Absorber>(k), h));
  EXPECT_EQ(profile(some, ozone, 20e3), 0) << "the column has none";
  EXPECT_EQ(profile({.ozone_du = 300}, ozone, 20e3), 0) << "its ozone is a filter";
  EXPECT_EQ(profile({.ozone_path = OzonePath::bent}, ozone, 20e3), 0) << "the column has none";
}

TEST(Breaks, AreWhereTheProfilesBend) {
  const auto breaks = breaks_m({.density = Density::us_1976, .dust_extinction_per_m = 1e-6});
  EXPECT_TRUE(std::ranges::is_sorted(breaks));
  EXPECT_EQ(breaks.back(), 86e3);
  EXPECT_EQ(std::ranges::count(breaks, 15e3) + std::ranges::count(breaks, 20e3), 2);
  EXPECT_EQ(breaks_m({.density = Density::none}), std::vector<double>{0});
}

TEST(CriticalRefractivity, IsWhereARayGoesRoundOnTheGround) {
  // US 1976 on the ground: T = 288.15 K, falling by 6.5 K/km, and dρ/dh = −ρ (34.163 − 6.5) / 288.15
  const double slope = -(34.163195 - 6.5) / 288.15e3, radius_m = 6.378e6;
  const double critical = critical_refractivity({}, radius_m);
  EXPECT_WITHIN_RELATIVE(critical, -1 / (1 + radius_m * slope), 1e-4,
                         "closed form, printed digits");
  EXPECT_WITHIN_RELATIVE(critical, 1.636e-3, 3e-4, "as it is told");
  EXPECT_NO_THROW(require_no_trap({}, radius_m, 0.999 * critical));
  EXPECT_THROW(require_no_trap({}, radius_m, 1.001 * critical), algebra::Error);
  EXPECT_NO_THROW(require_no_trap({.refraction = false}, radius_m, 0.1));
}

TEST(Atmosphere, OfTheDefaultsIsThePapersSphere) {
  EXPECT_TRUE(Atmosphere{}.symmetric());
  EXPECT_EQ(Atmosphere{}.top_radius_m(), 6.42e6);
}

TEST(Richest, HasTheMostOfEachAmountInEveryColumn) {
  Atmosphere air;
  air.belts = {{0, {}}, {3, {}}};
  air.regions = {{algebra::degrees(20), algebra::degrees(40), {}}};
  auto dusty = air, cloudy = air;
  dusty.belts[1].column.dust_extinction_per_m = 1e-6;
  dusty.regions[0].column.ozone_du = 500;
  cloudy.column.cloud_cover = 0.7;
  cloudy.belts[1].column.dust_extinction_per_m = 1e-7;
  cloudy.belts[0].column.cloud_per_m = 1e-5;
  dusty.belts[0].column.stratospheric_factor = 3;
  const std::array airs{air, dusty, cloudy};
  const auto rich = richest(airs);
  EXPECT_EQ(rich.column.cloud_cover, 0.7);
  EXPECT_EQ(rich.belts[0].column.dust_extinction_per_m, air.column.dust_extinction_per_m);
  EXPECT_EQ(rich.belts[1].column.dust_extinction_per_m, 1e-6);
  EXPECT_EQ(rich.regions[0].column.ozone_du, 500);
  EXPECT_EQ(rich.belts[0].column.cloud_per_m, 1e-5);
  EXPECT_EQ(rich.belts[0].column.stratospheric_factor, 3);
}

// The factor is that of a layer of as much more aerosol: its amount, and the colour that goes with it.
TEST(Spectra, AFactorOnTheStratosphereIsALayerOfThatDepth) {
  for (const double factor : {0.3, 1., 4.}) {
    Column asked, layered;
    const auto layer = StratosphericLayer::of_month(2015.7, algebra::degrees(-30), 15e3);
    asked.stratospheric_layer = std::make_shared<StratosphericLayer>(layer);
    asked.stratospheric_factor = factor;
    layered.stratospheric_layer = std::make_shared<StratosphericLayer>(
        layer.with_optical_depth(factor * layer.optical_depth()));
    for (const double nm : {450., 650.}) {
      const auto optics = sea_level_optics(algebra::nanometres(nm));
      EXPECT_WITHIN_RELATIVE(extinction_per_m(asked, optics, 21e3),
                             extinction_per_m(layered, optics, 21e3), 1e-12, "rounding");
    }
  }
  Column none;
  none.stratosphere = StratosphericAerosol::high;
  none.stratospheric_factor = 0;
  EXPECT_FALSE(has(none, stratosphere));
}

TEST(Richest, RefusesAirsThatDifferInAnythingElse) {
  EXPECT_THROW(richest({}), algebra::Error);
  Atmosphere air;
  air.belts = {{0, {}}, {3, {}}};
  air.regions = {{algebra::degrees(20), algebra::degrees(40), {}}};
  const auto refuses = [&](const auto& change) {
    auto other = air;
    other.column.ozone_du = 7;
    EXPECT_NO_THROW(richest(std::array{air, other}));
    change(other);
    EXPECT_THROW(richest(std::array{air, other}), algebra::Error);
    EXPECT_THROW(richest(std::array{other, air}), algebra::Error);
  };
  refuses([](Atmosphere& a) { a.column.stratosphere = StratosphericAerosol::high; });
  refuses([](Atmosphere& a) { a.belts[1].column.cloud_top_m = 5e3; });
  refuses([](Atmosphere& a) { a.belts.pop_back(); });
  refuses([](Atmosphere& a) { a.belts[1].from_north_rad = 2; });
  refuses([](Atmosphere& a) { a.regions[0].to = algebra::degrees(50); });
  refuses([](Atmosphere& a) { a.regions.clear(); });
  refuses([](Atmosphere& a) { a.earth = ellipsoid(0); });
  refuses([](Atmosphere& a) { a.molecules.dispersion = Dispersion::ciddor_1996; });
}

}  // namespace coppermoon::atmosphere::atmosphere_test
