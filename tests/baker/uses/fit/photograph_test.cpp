// SPDX-License-Identifier: MIT
#include "uses/fit/photograph.h"

#include "almanac/instant.h"
#include "support/testing.h"

namespace coppermoon::uses {
namespace {

constexpr double pixel_km = 2 * 1737.4 / (fit_disc_share * fit_side_px);

FitScene eclipsed() {
  FitScene scene;
  scene.sky = almanac::sky_at(almanac::instant_from_utc("2018-07-27T20:20:00Z"));
  scene.disc = {fit_side_px / 2., fit_side_px / 2., 100};
  return scene;
}

/// A Moon of half the scene's size, whose limb is some pixels of the photograph beside where its markings are.
colour::Registration registered(double beside_px) {
  const double middle = fit_side_px / 4.;
  return {{.scale = 0.5}, 0.99, {middle + beside_px, middle, 50}};
}

TEST(Photograph, LimbErrsByAThirdOfAPixelBesideTheMarkings) {
  EXPECT_EQ(off_limb_km(eclipsed(), registered(0.3)), 0);
  EXPECT_WITHIN_RELATIVE(off_limb_km(eclipsed(), registered(3.3)), 3 * 2 * pixel_km, 1e-9,
                         "rounding");
}

TEST(Photograph, PlaceIsBelievedLessWhereLimbAndMarkingsDisagree) {
  const double agreed = place_error_km(eclipsed(), registered(0), false),
               in_its_air = place_error_km(eclipsed(), registered(0), true);
  EXPECT_WITHIN_RELATIVE(agreed, std::hypot(0.3, 0.02) * 2 * pixel_km, 1e-9, "rounding");
  EXPECT_WITHIN_RELATIVE(in_its_air, std::hypot(0.2, 0.02) * 2 * pixel_km, 1e-9, "rounding");
  EXPECT_WITHIN_RELATIVE(place_error_km(eclipsed(), registered(2.3), true),
                         std::hypot(in_its_air, 2 * 2 * pixel_km), 1e-9, "rounding");
}

constexpr double step = 1 / 12.92 / 255;  // of 8 bits near black

/// A Moon all of whose ground is as bright and in one bin.
FitScene even_moon() {
  auto scene = eclipsed();
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

TEST(Photograph, RoundsTheMeanOfEvenLightButHardlyThatOfLightThatVaries) {
  const auto scene = even_moon();
  const auto even = binned(scene, rounded(30.4, 0), {}),
             varied = binned(scene, rounded(30.4, 8), {});
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_WITHIN_RELATIVE(even.errors(0, k), 0.3 * step, 0.01, "steps of float");
    EXPECT_LT(varied.errors(0, k), 0.1 * even.errors(0, k));
    EXPECT_WITHIN(varied.values(0, k), 30.4 * step, 2 * varied.errors(0, k), "two deviations");
  }
}

}  // namespace
}  // namespace coppermoon::uses
