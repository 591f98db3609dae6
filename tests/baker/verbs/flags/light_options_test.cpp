// SPDX-License-Identifier: MIT
#include "verbs/flags/light_options.h"

#include "algebra/error.h"
#include "support/testing.h"
#include "verbs/command_line.h"

namespace coppermoon::verbs::light_options_test {

uses::LightRequest request_after(const std::string& flags) {
  Verb verb;
  LightOptions options;
  add_light_options(verb, options);
  add_photon_file_options(verb, options);
  std::istringstream words(flags);
  take(verb, {std::istream_iterator<std::string>(words), {}});
  return light_request(options);
}

TEST(LightRequest, WithoutFlagsIsTheStandardLight) {
  const auto request = request_after("");
  EXPECT_EQ(request.air.atmosphere, "standard");
  EXPECT_EQ(request.wish.tolerance, 0.01);
  EXPECT_EQ(request.solver, uses::Solver::automatic);
  EXPECT_EQ(request.scattered_light, uses::ScatteredLight::automatic);
  EXPECT_FALSE(request.photons || request.limb_darkening || request.starlight);
}

TEST(LightRequest, OfThePapersQualityIsThePapersSimulation) {
  const auto request = request_after("--quality paper");
  EXPECT_EQ(request.solver, uses::Solver::literal);
  EXPECT_EQ(request.photons, 1e7);
  EXPECT_EQ(request.by_hand.bands, 200);
  EXPECT_FALSE(request.by_hand.terms->scattered_light);
  const auto fewer = request_after("--quality paper --photons 5 --bands 3 --leave-out none");
  EXPECT_EQ(fewer.photons, 5);
  EXPECT_EQ(fewer.by_hand.bands, 3);
  EXPECT_TRUE(fewer.by_hand.terms->scattered_light);
}

TEST(LightRequest, ReadsRegionsOnce) {
  const auto request =
      request_after("--region from-latitude=-90,to-latitude=0,dust-extinction=1e-5");
  ASSERT_EQ(request.air.regions.size(), 1U);
  EXPECT_EQ(request.air.regions[0].from_latitude, -90);
  EXPECT_EQ(request.air.regions[0].column.dust_extinction_per_m, 1e-5);
}

TEST(LightRequest, RefusesPhotonsFilesWithoutPhotons) {
  EXPECT_THROW(request_after("--shard 1/3"), algebra::Error);
  EXPECT_THROW(request_after("--solver photons --shard 4/3"), algebra::Error);
  EXPECT_EQ(request_after("--solver photons --shard 1/3").photon_files.shard->parts, 3U);
}

TEST(LightRequest, HasAKeyThatKnowsTheAirAndNotTheNumberOfPhotons) {
  const auto key = [](const std::string& flags) {
    return request_after("--solver photons " + flags).photon_files.key;
  };
  const auto usual = key("");
  EXPECT_EQ(key("--photons 5 --shard 1/3 --keep a --add b --add c --starlight on"), usual);
  for (const std::string other : {"--ozone-du 300", "--seed 2", "--rays 99", "--step-km 3",
                                  "--ring-km 7", "--limb-darkening off", "--atmosphere paper"})
    EXPECT_NE(key(other), usual) << other;
  EXPECT_NE(request_after("--solver literal").photon_files.key, usual);
}

}  // namespace coppermoon::verbs::light_options_test
