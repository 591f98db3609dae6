// SPDX-License-Identifier: MIT
// Each term's switch does something, in the direction that physics says, and about as much.
#include <nlohmann/json.hpp>

#include "support/program.h"

namespace coppermoon::end_to_end::terms_test {

enum Place { axis, half_way, edge };       // 0, 2300, 4400 km
enum Colour { blue, green, orange, red };  // 450, 550, 600 (the deepest of ozone), 650 nm; and 690

class Terms : public ProgramTest {
 protected:
  using Ratios = std::vector<std::vector<double>>;  // [place][colour]

  /// In one column of air, but for what a test says.
  std::string air = "undated";

  Ratios shadow(Words flags) const {
    return json_of(words_of("shadow 2008-02-21T03:26:00Z --wavelengths 450,550,600,650,690 "
                            "--axis-distances 0,2300,4400 --atmosphere {} --scattered-light off",
                            air) +
                   flags)
        .at("irradiance_ratio")
        .get<Ratios>();
  }

  /// log₂ of the light with those flags over the light without: stops by [place][colour].
  Ratios stops(const Words& flags) const {
    auto changed = shadow(flags);
    static std::map<std::string, Ratios> without;  // by air, once for all tests
    auto& standard = without[air];
    if (standard.empty()) standard = shadow({});
    for (std::size_t place = 0; place < changed.size(); ++place)
      for (std::size_t colour = 0; colour < changed[place].size(); ++colour)
        changed[place][colour] = std::log2(changed[place][colour] / standard[place][colour]);
    return changed;
  }
};

void expect_between(double stops, double least, double most) {
  EXPECT_GE(stops, least);
  EXPECT_LE(stops, most);
}

TEST_F(Terms, OfTheAirOfAMonthAllTakeLight) {
  air = "standard";
  for (const Words flags :
       {"--cloud-chance 0", "--cirrus 0", "--free-troposphere 0", "--tropospheric-aerosol 0",
        "--stratospheric-aerosol 0", "--oxygen-pairs off", "--oxygen-bands off", "--water-vapour 0",
        "--nitrogen-dioxide off", "--ozone-du 0"}) {
    const auto change = stops(flags);
    double most = 0;
    for (const auto& place : change)
      for (const double one : place) {
        EXPECT_GT(one, -1e-3) << flags[0] << ": the quadrature's own error, 3e-4, of two shadows";
        most = std::max(most, one);
      }
    EXPECT_GT(most, 0.005) << flags[0] << ": pairs of oxygen, beside their bands, are the least";
  }
}

TEST_F(Terms, BandsOfOxygenAndWaterTakeDeepRedAndLittleOfV) {
  const auto magnitudes = [&](const Words& flags) {
    return json_of(Words("brightness 2018-01-31T13:29:51Z") + flags).at("magnitudes");
  };
  const auto with = magnitudes({}), without = magnitudes("--oxygen-bands off --water-vapour 0");
  const auto taken = [&](const char* band) {
    return with[band].get<double>() - without[band].get<double>();
  };
  EXPECT_WITHIN(taken("B"), 0, 1e-3, "no band lies there");
  EXPECT_WITHIN(taken("V"), 0.011, 0.003, "the figure in docs/exactness.md, and the light's error");
  EXPECT_WITHIN(taken("R"), 0.125, 0.01, "the figure in docs/exactness.md, and the light's error");
}

TEST_F(Terms, WithoutLimbDarkeningTheShadowIsBrighterAndBluer) {
  // It is lit by the Sun's rim, which has 0.3 to 1 of the disc's mean light and least of it in the
  // blue.
  const auto change = stops("--limb-darkening off");
  for (const auto place : {axis, half_way, edge}) {
    expect_between(change[place][green], 0.1, std::log2(1 / 0.3));
    EXPECT_GT(change[place][blue], change[place][red] + 0.1);
  }
}

TEST_F(Terms, OnASphereTheEdgeIsDarker) {
  // Its limb stands 0 to 21 km higher, 10 km in the mean, and so does its shadow: 100 km at the edge
  // are half a stop.
  expect_between(stops("--earth sphere")[edge][green], -0.10, -0.02);
}

TEST_F(Terms, AirCutAt42KmLetsMoreThroughOrangeMost) {
  // Rays to the edge pass 20 to 25 km up, where some 2 % of the air they meet and of the ozone is
  // above 42 km: of 1 to 2.3 stops of scattering, and at 600 nm of 2.5 stops of ozone.
  const auto change = stops("--density yapo-cutler");
  expect_between(change[edge][orange], 0.01, 0.1);
  expect_between(change[edge][blue], 0.01, 0.1);
  EXPECT_GT(change[edge][orange], change[edge][blue] + 0.005);
}

TEST_F(Terms, DispersionByTheCrcLightsTheAxisLess) {
  // Its refractivity is 0.3 % smaller: rays that reach the axis pass some 20 m lower, in air denser
  // by as much: 0.3 % of 5 stops.
  const auto change = stops("--dispersion crc");
  expect_between(change[axis][orange], -0.04, -0.004);
  expect_between(change[axis][red], -0.04, -0.004);
}

TEST_F(Terms, AFixedKingFactorScattersTooMuchRedAndTooLittleBlue) {
  // Bates (1984): F is above 1.050 in the blue and 0.2 % below it in the red, of 14.6 and 3.4 stops.
  const auto change = stops("--king-factor fixed");
  expect_between(change[axis][blue], 0.0003, 0.02);
  expect_between(change[axis][red], -0.02, -0.003);
}

TEST_F(Terms, WithoutOzoneTheOrangeComesThrough) {
  // 345 DU at 600 nm are 0.047 optical depths, and a ray that grazes the ground meets the layer, 22
  // km above it, at an angle that makes 24 of each, one that grazes 10 km, 33: 1.6 to 2.2 stops.
  const auto change = stops("--ozone-du 0");
  expect_between(change[axis][orange], 1.6, 2.2);
  expect_between(change[axis][blue], 0.01, 0.15);
  EXPECT_GT(change[edge][orange], change[axis][orange] + 0.2) << "the turquoise rim";
}

TEST_F(Terms, OzoneAsAFilterIsTheSameEverywhere) {
  const auto none = stops("--ozone-du 0"), filter = stops("--ozone-path filter");
  const double on_axis = none[axis][orange] - filter[axis][orange];
  for (const auto place : {half_way, edge})
    EXPECT_WITHIN(none[place][orange] - filter[place][orange], on_axis, 1e-3,
                  "the quadrature's own error, 3e-4, of two shadows");
  EXPECT_GT(std::abs(filter[edge][orange] - filter[axis][orange]), 0.2)
      << "along the path it is not";
}

TEST_F(Terms, WithoutTroposphericAerosolTheAxisIsBrighter) {
  // A ray h above the ground meets √(2πR/H) exp(−h/H) = 141 exp(−h/H) of 0.07 optical depths, H =
  // 2 km; those to the axis pass at 2 to 6 km: 5.2 to 0.7 stops.
  const auto change = stops("--tropospheric-aerosol 0");
  expect_between(change[axis][green], 0.7, 5.2);
  EXPECT_LT(change[half_way][green], change[axis][green] / 2);
  expect_between(change[edge][green], 0.001, 0.1);
}

TEST_F(Terms, WithoutStratosphericAerosolAllIsBrighterMostOfAllBlue) {
  const auto change = stops("--stratospheric-aerosol none");
  for (const auto place : {axis, half_way, edge}) {
    EXPECT_GT(change[place][red], 0.1);
    EXPECT_GT(change[place][blue], change[place][red]);
  }
}

TEST_F(Terms, WithoutCloudTheAxisIsBrighterByAllTheCloudHeldBack) {
  const auto change = stops("--cloud-cover 0");
  EXPECT_WITHIN(change[axis][green], std::log2(1 / 0.3), 1e-3,
                "rays bent to the axis pass below 6 km, cloud ends at 10; quadrature 3e-4, twice");
  EXPECT_GT(change[half_way][green], change[edge][green] + 0.2);
  expect_between(change[edge][green], 0.003, 0.2);
}

TEST_F(Terms, WithoutRayleighScatteringTheAxisIsBrighterAsTheFourthPowerSays) {
  const auto change = stops("--rayleigh off");
  EXPECT_WITHIN_RELATIVE(change[axis][blue] / change[axis][red], std::pow(650. / 450, 4), 0.1,
                         "each colour takes the paths that let it through");
  EXPECT_GT(change[edge][green], 0.5);
}

TEST_F(Terms, WithoutRefractionTheUmbraIsBlack) {
  for (const auto& place : shadow("--refraction off"))
    for (const double ratio : place) EXPECT_EQ(ratio, 0);
}

TEST_F(Terms, ScatteredLightAndStarlightLightTheBlueOfTheAxisMost) {
  for (const std::string flag : {"--scattered-light", "--starlight"}) {
    const auto off = shadow({flag, "off"}), on = shadow({flag, "on"});
    EXPECT_GT(on[axis][blue], 1.001 * off[axis][blue]) << flag << ": there is 1e-8 of sunlight";
    EXPECT_LT(on[edge][green], 1.01 * off[edge][green]) << flag << ": there is 5e-4 of sunlight";
  }
}

}  // namespace coppermoon::end_to_end::terms_test
