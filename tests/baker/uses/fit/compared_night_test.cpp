// SPDX-License-Identifier: MIT
// Intervals of nights that the model itself makes: errors drawn as they are believed, no pictures.
#include "uses/fit/compared_night.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "algebra/random.h"
#include "almanac/instant.h"

namespace coppermoon::uses {
namespace {

constexpr double clock_error_s = 120;

double normal(algebra::Random& random) {
  return std::sqrt(-2 * std::log(1 - random.uniform())) *
         std::cos(2 * std::numbers::pi * random.uniform());
}

/// Photograph of a partial phase, with 2 % of noise in each bin and channel.
NightPhotograph photograph() {
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2018-07-27T19:15:00Z"));
  MoonRequest moon;
  moon.light.air.atmosphere = "undated";
  moon.texture_width = 256;
  NightPhotograph made;
  made.scene = fit_scene(moon, groundwork_of(moon, std::span(&sky, 1)), {}, sky);
  const algebra::Grid<double> none(made.scene.bins, 3);
  made.light = {made.scene.usual_values, made.scene.usual_values, none, none, {}};
  for (double& error : made.light.errors.values()) error *= 0.02;
  made.errors.value_per_cd_m2 = 1;
  made.errors.weather_error = 0.1;
  return made;
}

/// How often intervals of the air's three numbers and of the clock held the truth.
using Held = std::array<int, 4>;

Held held_in(int nights) {
  const auto seen = photograph();
  LightRequest request;
  request.air.atmosphere = "undated";
  const auto light =
      night_light(request, Unknowns::amounts, std::span(&seen, 1), std::array{seen.scene.sky.when},
                  clock_error_s, FittedAirs::coarse);
  const ComparedNight compared(std::span(&seen, 1), {.clock_error_s = clock_error_s});
  Held held{};
  for (int night = 0; night < nights; ++night) {
    algebra::Random random(20180727, static_cast<std::uint64_t>(night));
    AirNumbers truth{};
    std::array<double, 3> places{};
    for (std::size_t a = 0; a < 3; ++a) {
      const auto& unknown = unknowns_of(Unknowns::amounts)[a];
      places[a] = std::lerp(unknown.on_axis(unknown.least), unknown.on_axis(unknown.most),
                            random.uniform());
      truth[a] = unknown.from_axis(places[a]);
    }
    std::vector<double> normals(compared.count());
    for (double& one : normals) one = normal(random);
    const double clock_s = clock_error_s * normal(random);
    const auto weather =
        static_cast<std::size_t>(random.uniform() * ComparedNight::weather_strengths);
    const auto witness = compared.witness(light.at(truth), clock_s, weather, normals);
    const DataSet data{
        &light,
        [&](std::span<const algebra::Grid<double>> lights) { return witness.goodness(lights); },
        witness.count()};
    const auto found = fitted_air(std::span(&data, 1));
    for (std::size_t a = 0; a < 3; ++a) {
      const auto& [median, low, high, information] = found.posterior.estimates[a];
      held[a] += places[a] >= low && places[a] <= high;
    }
    held[3] += std::abs(found.clocks.front().seconds - clock_s) < found.clocks.front().error_s;
  }
  return held;
}

TEST(ComparedNight, HasIntervalsThatHoldTheTruthInTwoOfThreeNights) {
  int sum = 0;
  for (const int held : held_in(10)) {
    EXPECT_GE(held, 3) << "of 10 fair intervals of 68 %, in 999 of 1000 such tests";
    sum += held;
  }
  // of 40, 18 to 36 in 99 of 100: those of one night hang together
  EXPECT_GE(sum, 18);
  EXPECT_LE(sum, 36);
}

TEST(ComparedNightThoroughly, HasIntervalsThatHoldTheTruthInTwoOfThreeNights) {
  for (const int held : held_in(200)) {
    fmt::print("{} of 200\n", held);
    // 136 ± 6.6; within 2.6 of these in 99 of 100 such tests
    EXPECT_GE(held, 119);
    EXPECT_LE(held, 153);
  }
}

}  // namespace
}  // namespace coppermoon::uses
