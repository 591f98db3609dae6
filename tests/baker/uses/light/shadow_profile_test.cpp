// SPDX-License-Identifier: MIT
#include "uses/light/shadow_profile.h"

#include "almanac/instant.h"
#include "support/testing.h"

namespace coppermoon::uses::shadow_profile_test {

ShadowProfile profile_at(const LightRequest& request, double position_angle_deg) {
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2018-07-27T20:21:45Z"));
  return shadow_profile(request, shadow_at_the_moon(request, sky),
                        {.wavelengths_nm = {550},
                         .axis_distances_m = {1e6, 2e6, 3e6, 4e6},
                         .position_angle_deg = position_angle_deg});
}

LightRequest in_undated_air() {
  LightRequest request;
  request.air.atmosphere = "undated";
  return request;
}

TEST(ShadowProfile, OfAnEllipsoidIsAWaveAroundTheAxis) {
  const auto request = in_undated_air();
  const auto pole = profile_at(request, 0), equator = profile_at(request, 90);
  for (const double angle : {7.5, 50., 187.5, 352.}) {
    const auto here = profile_at(request, angle);
    for (std::size_t d = 0; d < here.axis_distances_m.size(); ++d) {
      const double mean = (pole.ratio(d, 0) + equator.ratio(d, 0)) / 2,
                   wave = (pole.ratio(d, 0) - equator.ratio(d, 0)) / 2;
      EXPECT_WITHIN(here.ratio(d, 0), mean + wave * std::cos(angle * std::numbers::pi / 90),
                    2e-3 * std::abs(wave) + 1e-15,
                    "3/128 of the fourth power of a sector of 15 degrees, twice: 1.8e-3")
          << angle << " degrees, " << here.axis_distances_m[d] << " m";
    }
  }
}

/// At 450 nm on the axis, over sunlight.
double blue_on_the_axis(LightRequest request, ScatteredLight scattered) {
  request.scattered_light = scattered;
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2018-07-27T20:21:45Z"));
  return shadow_profile(request, shadow_at_the_moon(request, sky),
                        {.wavelengths_nm = {450}, .axis_distances_m = {0}})
      .ratio(0, 0);
}

TEST(ShadowProfile, HasScatteredLightUnlessItIsOffOrLeftOut) {
  using enum ScatteredLight;
  auto request = in_undated_air();
  request.air.column.stratosphere = atmosphere::StratosphericAerosol::extreme;
  const double as_usual = blue_on_the_axis(request, automatic),
               without = blue_on_the_axis(request, off);
  EXPECT_EQ(as_usual, blue_on_the_axis(request, on));
  EXPECT_GT(as_usual, 5e-7) << "1e-6 under a stratosphere full of ash: shadow::twilight";
  EXPECT_LT(without, 1e-10) << "nothing else gets through it";
  request.by_hand.terms = plan::Work{.scattered_light = false};
  EXPECT_EQ(blue_on_the_axis(request, on), without);
}

TEST(ShadowProfile, IsWithoutTheTermsThatAreLeftOut) {
  auto request = in_undated_air();
  request.scattered_light = ScatteredLight::off;
  request.by_hand.terms = plan::Work{.ellipsoid = false};
  const auto pole = profile_at(request, 0), equator = profile_at(request, 90);
  for (std::size_t d = 0; d < pole.axis_distances_m.size(); ++d)
    EXPECT_EQ(pole.ratio(d, 0), equator.ratio(d, 0)) << "a sphere's shadow is alike all around";
  request.by_hand.terms = plan::Work{.refracted = false};
  const auto dark = profile_at(request, 0);
  for (const double ratio : dark.ratio.values()) EXPECT_EQ(ratio, 0);
}

TEST(ShadowProfile, OfFewPhotonsIsNeverDarkerThanBlack) {
  auto request = in_undated_air();
  request.solver = Solver::table;
  request.photons = 3000;
  for (const double angle : {7.5, 22.5, 97.5}) {
    const auto here = profile_at(request, angle);
    for (const double ratio : here.ratio.values()) EXPECT_GE(ratio, 0);
  }
}

}  // namespace coppermoon::uses::shadow_profile_test
