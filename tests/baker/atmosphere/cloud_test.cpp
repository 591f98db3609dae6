// SPDX-License-Identifier: MIT
#include "atmosphere/cloud.h"

#include "support/testing.h"

namespace coppermoon::atmosphere::cloud_test {

/// A place, and its tropopause.
struct Place {
  double latitude, tropopause_m;
};

/// Share of straight rays with that lowest height that no cloud stops: the chance summed in steps of
/// 1 km along them.
double share_that_passes(const Place& place, double lowest_m) {
  constexpr double radius_m = 6.371e6, step_m = 1e3;
  double depth = 0;
  for (double along = step_m / 2; along < 700e3; along += step_m)
    depth += 2 * step_m * cloud_chance_per_m(algebra::degrees(place.latitude)) *
             cloud_profile(place.tropopause_m, std::hypot(radius_m + lowest_m, along) - radius_m);
  return std::exp(-depth);
}

// Woodbury & McCormick (1983): followed down to 7 km 60 % at high latitudes, 30 % in the tropics.
TEST(CloudChance, LeavesWhatOccultationsSaw) {
  const Place tropics{5, 16.4e3}, north{65, 9.5e3}, south{-65, 9.5e3}, desert{25, 16.3e3};
  EXPECT_WITHIN(share_that_passes(north, 7e3), 0.6, 0.02, "published to 0.1");
  EXPECT_WITHIN(share_that_passes(tropics, 7e3), 0.3, 0.02, "published to 0.1");
  EXPECT_EQ(share_that_passes(south, 7e3), share_that_passes(north, 7e3));
  EXPECT_GT(share_that_passes(desert, 7e3), share_that_passes(tropics, 7e3) + 0.1)
      << "distinct minima of cloud near 20 to 30 degrees";
  EXPECT_THROW(cloud_chance_per_m(algebra::degrees(91)), algebra::Error);
}

TEST(CloudChance, HasNoEdge) {
  double before = 1;
  for (double h = 20e3; h >= 0; h -= 250) {
    const double here = share_that_passes({0, 16e3}, h);
    EXPECT_LE(here, before) << h;
    EXPECT_LT(before - here, 0.06) << h << ": a deck of cloud takes 0.7 at once";
    before = here;
  }
  EXPECT_EQ(cloud_profile(11e3, 13e3), 0);
  EXPECT_EQ(cloud_profile(11e3, 9e3), 1);
}

TEST(Cirrus, IsThinUnderTheTropopause) {
  double vertical = 0;
  for (double h = 5; h < 25e3; h += 10) vertical += 10 * cirrus_extinction_per_m(16e3, h);
  EXPECT_WITHIN_RELATIVE(vertical, 0.5 * 2e-3 * 5 / 3., 0.02,
                         "3 km of it, and half of 2 km more at either end");
  EXPECT_EQ(cirrus_extinction_per_m(16e3, 18e3), 0);
  EXPECT_EQ(cirrus_extinction_per_m(16e3, 10e3), 0);
}

}  // namespace coppermoon::atmosphere::cloud_test
