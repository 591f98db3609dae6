// SPDX-License-Identifier: MIT
#include "uses/tradeoff/runs.h"

#include <chrono>
#include <thread>

#include "almanac/instant.h"
#include "support/testing.h"

namespace coppermoon::uses::runs_test {

Yardstick coarse_yardstick() {
  MoonRequest moon;
  moon.albedo_map = "built-in";
  moon.texture_width = 64;
  moon.light.air.atmosphere = "clear";
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2008-02-21T03:26:05Z"));
  return {measured_scene(moon, sky),
          {.rays = 300, .bands = 10, .spacing_m = 200e3, .texture_width = 64}};
}

Sweep of_photons(std::vector<double> photons) {
  return {{.solver = plan::Solver::table,
           .wavelengths = 10,
           .rays = 3000,
           .replicas = 500,
           .texture_width = 64},
          "photons",
          &Trial::photons,
          std::move(photons)};
}

/// Stopwatch that notes the photons of each run, by which a run takes a second for tables and 10 µs a photon.
auto noting(std::vector<double>& run) {
  return [&](const Trial& trial, const std::function<void()>& make) {
    make();
    run.push_back(trial.photons);
    return 1 + 1e-5 * trial.photons;
  };
}

TEST(MeasuredTrials, ExtrapolateWhatGrowsWithThePhotonsAlone) {
  auto yardstick = coarse_yardstick();
  const auto sweep = of_photons({1e3, 1e6});
  std::vector<double> run;
  const auto all =
      measured_trials({&sweep, 1}, yardstick, {.longest_s = 0, .stopwatch = noting(run)});
  EXPECT_EQ(run.size(), 4U)
      << "four times the photons each, until they show beside the tables: 1e3 to 64e3";
  ASSERT_EQ(all.size(), 2U);
  EXPECT_FALSE(all[0].extrapolated);
  EXPECT_TRUE(all[1].extrapolated);
  EXPECT_WITHIN(all[1].seconds, 11, 1e-9, "a straight line's rounding");
  EXPECT_WITHIN(all[1].errors.umbra.rms, all[0].errors.umbra.rms / std::sqrt(1000), 1e-12,
                "as the root of the photons' number");
}

TEST(MeasuredTrials, RunAtOnceWhatCannotTakeTooLong) {
  auto yardstick = coarse_yardstick();
  const auto sweep = of_photons({1e3, 1e4});
  std::vector<double> run;
  const auto all =
      measured_trials({&sweep, 1}, yardstick, {.longest_s = 11, .stopwatch = noting(run)});
  EXPECT_EQ(run, (std::vector<double>{1e3, 1e4}))
      << "ten times the photons: at most ten times 1.01 s";
  ASSERT_EQ(all.size(), 2U);
  EXPECT_FALSE(all[1].extrapolated);
}

TEST(MeasuredTrials, TakeATexturesLightFromTheSweepBeforeIt) {
  auto yardstick = coarse_yardstick();
  const Trial middle{
      .solver = plan::Solver::quadrature, .wavelengths = 10, .rays = 60, .texture_width = 64};
  const std::vector<Sweep> after{{middle, "rays", &Trial::rays, {60}},
                                 {middle, texture_sweep, &Trial::texture_width, {32, 64}}},
      alone{after[1]};
  const auto with = measured_trials(after, yardstick, {}),
             without = measured_trials(alone, yardstick, {});
  ASSERT_EQ(with.size(), 3U);
  ASSERT_EQ(without.size(), 2U);
  for (const std::size_t i : {0U, 1U}) {
    EXPECT_EQ(with[i + 1].errors.umbra.rms, without[i].errors.umbra.rms);
    EXPECT_EQ(with[i + 1].errors.picture.mean, without[i].errors.picture.mean);
  }
}

TEST(MeasuredTrials, TakeTheirSecondsFromTheClock) {
  const auto nap = [] { std::this_thread::sleep_for(std::chrono::milliseconds(20)); };
  EXPECT_GE(seconds_of({}, nap), 0.02) << "a nap is never shorter";
}

}  // namespace coppermoon::uses::runs_test
