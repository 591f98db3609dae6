// SPDX-License-Identifier: MIT
#include "shadow/landed_light.h"

#include "shadow/irradiance.h"
#include "support/testing.h"

namespace coppermoon::shadow::landed_light_test {

constexpr double sun_m = 1.5e11, moon_m = 3.8e8, radius_m = 6.4e6;

/// Five rays 25 m apart of one wavelength, which air neither bends nor dims.
photons::Fan five_rays() {
  photons::Fan fan;
  for (const double height : {0., 25., 50., 75., 100.}) {
    fan.tangent_height_m.push_back(height);
    fan.impact_height_m.push_back(height);
    fan.bending_rad.push_back(0);
    fan.optical_depth.push_back(0);
    if (height > 0) fan.filter.push_back(1);
  }
  return fan;
}

double landing_bin(double impact_height_m, double bin_m) {
  return landing_m(radius_m + impact_height_m, 0, sun_m, moon_m) / bin_m;
}

/// ∫ (r − centre)^m b db of all five, r in bins.
double moment_about(double centre, std::size_t moment, double bin_m) {
  const std::array fans{five_rays()};
  const LandedLight landed(fans, {sun_m, moon_m, bin_m, 1e8}, radius_m);
  std::array<double, moments> factors{1, 0, 0};
  if (moment == 1) factors = {-centre, 1, 0};
  if (moment == 2) factors = {centre * centre, -2 * centre, 1};
  const double* sums =
      landed.sums() + static_cast<std::size_t>(landed.last() - landed.first()) * moments * lanes;
  return factors[0] * sums[0] + factors[1] * sums[lanes] + factors[2] * sums[2 * lanes];
}

TEST(LandedLight, HasTheMomentsOfAnEvenSpread) {
  const double light = 100 * (radius_m + 50);  // ∫ b db
  for (const double bin_m : {17., 45., 1000., 1e6}) {
    const double low = landing_bin(0, bin_m), high = landing_bin(100, bin_m);
    const double middle = (low + high) / 2, width = high - low;
    EXPECT_WITHIN_RELATIVE(moment_about(middle, 0, bin_m), light, 1e-12, "closed form");
    EXPECT_WITHIN(moment_about(middle, 1, bin_m), 0, 1e-5 * light * width,
                  "light grows by 16e-6 from the first ray to the last");
    EXPECT_WITHIN_RELATIVE(moment_about(middle, 2, bin_m), light * width * width / 12, 1e-3,
                           "closed form; of a bin 1e6 m wide, 6 digits of 16 are left")
        << bin_m;
  }
}

TEST(LandedLight, LeavesOutWhatLandsBeyondItsReach) {
  const std::array fans{five_rays()};
  const double bin_m = 7, reach_m = (landing_bin(0, bin_m) + landing_bin(60, bin_m)) / 2 * bin_m;
  const LandedLight whole(fans, {sun_m, moon_m, bin_m, 1e8}, radius_m),
      near(fans, {sun_m, moon_m, bin_m, reach_m}, radius_m),
      none(fans, {sun_m, moon_m, bin_m, 1e3}, radius_m);
  ASSERT_EQ(near.first(), whole.first());
  EXPECT_LT(near.last(), whole.last());
  EXPECT_GE(near.last() * bin_m, reach_m);
  const auto count = static_cast<std::size_t>(near.last() - near.first() + 1) * moments * lanes;
  for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(near.sums()[i], whole.sums()[i]) << i;
  EXPECT_EQ(none.last(), none.first());
  EXPECT_EQ(none.sums()[0], 0);
}

/// Share of ∫ exp(−depth t) dt from 0 to 1 that lies below some t.
double share_below(double t, double depth) { return std::expm1(-depth * t) / std::expm1(-depth); }

TEST(LandedLight, FallsAndRisesAsTheOpticalDepthOfItsRays) {
  const double bin_m = 0.7, low = landing_bin(0, bin_m), high = landing_bin(100, bin_m);
  for (const double depth : {0.1, 0.9, 8., 50., 4000.})
    for (const bool rising : {false, true}) {
      auto fan = five_rays();
      for (std::size_t i = 0; i < 5; ++i)
        fan.optical_depth[i] = depth / 4 * static_cast<double>(rising ? 4 - i : i);
      const LandedLight landed(std::array{fan}, {sun_m, moon_m, bin_m, 1e8}, radius_m);
      const double light = -100 * (radius_m + 50) * std::expm1(-depth) / depth;
      for (int node = landed.first(); node <= landed.last(); ++node) {
        const double t = std::clamp((node - low) / (high - low), 0., 1.),
                     share = rising ? 1 - share_below(1 - t, depth) : share_below(t, depth);
        const auto row = static_cast<std::size_t>(node - landed.first()) * moments * lanes;
        EXPECT_WITHIN(
            landed.sums()[row] / light, share, 2e-5,
            "closed form; the limb's length grows by 16e-6 from the first ray to the last")
            << depth << (rising ? " rising, bin " : " falling, bin ") << node;
      }
    }
}

}  // namespace coppermoon::shadow::landed_light_test
