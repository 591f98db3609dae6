// SPDX-License-Identifier: MIT
#include "uses/fit/binned_photograph.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/within.h"

namespace coppermoon::uses::binned_photograph_test {

constexpr double step = 1 / 12.92 / 255;  // of 8 bits near black

/// A Moon all of whose ground is as bright and in one bin.
FitScene even_moon() {
  FitScene scene;
  const double middle = fit_side_px / 2., radius = 0.9 * fit_disc_share * middle;
  scene.bins = 1;
  scene.usual_values = algebra::Grid<double>(1, 3);
  for (double& value : scene.usual_values.values()) value = 30 * step;
  scene.glow = colour::Image(fit_side_px, fit_side_px);
  for (std::size_t r = 0; r < fit_side_px; ++r)
    for (std::size_t c = 0; c < fit_side_px; ++c)
      if (std::hypot(static_cast<double>(r) + 0.5 - middle, static_cast<double>(c) + 0.5 - middle) <
          radius)
        scene.grounds.push_back({r * fit_side_px + c, {}, 1, 0, 0});
  return scene;
}

/// Photograph of it, rounded to steps; from left to right the light grows by some of them.
MoonPart rounded(double steps, double more_steps) {
  MoonPart part{.photo = {fit_side_px, fit_side_px, {"R", "G", "B"}}};
  part.steps = {step, step, step};
  const double middle = fit_side_px / 2., radius = fit_disc_share * middle;
  for (std::size_t r = 0; r < fit_side_px; ++r)
    for (std::size_t c = 0; c < fit_side_px; ++c) {
      const double x = static_cast<double>(c) + 0.5 - middle,
                   y = static_cast<double>(r) + 0.5 - middle;
      if (std::hypot(x, y) > radius) continue;
      for (std::size_t k = 0; k < 3; ++k)
        part.photo(r, c, k) =
            static_cast<float>(step * std::round(steps + more_steps * x / (2 * radius)));
    }
  return part;
}

TEST(BinnedPhotograph, RoundsTheMeanOfEvenLightButHardlyThatOfLightThatVaries) {
  const auto scene = even_moon();
  const auto even = binned(scene, rounded(30.4, 0), {}),
             varied = binned(scene, rounded(30.4, 8), {});
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_WITHIN_RELATIVE(even.errors(0, k), 0.3 * step, 0.01, "steps of float");
    EXPECT_LT(varied.errors(0, k), 0.1 * even.errors(0, k));
    EXPECT_WITHIN(varied.values(0, k), 30.4 * step, 2 * varied.errors(0, k), "two deviations");
  }
}

/// Pixels of more than 8 bits have no step below which glow would go unnoticed.
TEST(BinnedPhotograph, TakesNoGlowOffWhereTheSkyIsBlack) {
  auto scene = even_moon();
  for (auto& pixel : scene.glow.values()) pixel.fill(static_cast<float>(300 * step));
  auto moon = rounded(30, 0);
  moon.steps = {0, 0, 0};
  const auto found = binned(scene, moon, {});
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_WITHIN_RELATIVE(found.values(0, k), 30 * step, 1e-6, "floats");
}

}  // namespace coppermoon::uses::binned_photograph_test
