// SPDX-License-Identifier: MIT
#include "uses/tradeoff/runs.h"

#include <gtest/gtest.h>

#include "almanac/instant.h"

namespace coppermoon::uses {
namespace {

TEST(MeasuredTrials, ExtrapolateWhatGrowsWithThePhotonsAlone) {
  MoonRequest moon;
  moon.albedo_map = "built-in";
  moon.texture_width = 64;
  moon.light.air.atmosphere = "clear";
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2008-02-21T03:26:05Z"));
  Yardstick yardstick(measured_scene(moon, sky),
                      {.rays = 300, .bands = 10, .spacing_m = 200e3, .texture_width = 64});
  const Sweep sweep{{.solver = table_solver,
                     .wavelengths = 10,
                     .rays = 3000,
                     .replicas = 500,
                     .texture_width = 64},
                    "photons",
                    &Trial::photons,
                    {1e3, 1e6}};
  const auto all = measured_trials({&sweep, 1}, yardstick, {.longest_s = 0});
  ASSERT_EQ(all.size(), 2U);
  EXPECT_TRUE(all[1].extrapolated);
  EXPECT_LT(all[1].seconds, 200 * all[0].seconds)
      << "a thousand times the photons, of which the tables take most of the time: some ten times";
  EXPECT_GE(all[1].seconds, all[0].seconds);
}

}  // namespace
}  // namespace coppermoon::uses
