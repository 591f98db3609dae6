// SPDX-License-Identifier: MIT
#include "colour/bracket.h"

#include "colour/photograph.h"
#include "support/testing.h"

namespace coppermoon::colour::bracket_test {

constexpr std::size_t side = 200;

/// From what one exposure drowns in noise to what another clips: 0.01 to 1000 cd/m², column by column.
Image ramp() {
  Image scene(side, side);
  for (std::size_t r = 0; r < side; ++r)
    for (std::size_t c = 0; c < side; ++c) {
      const float light =
          static_cast<float>(std::pow(10., -2 + 5 * static_cast<double>(c) / (side - 1)));
      scene(r, c) = {light, light, light};
    }
  return scene;
}

Camera camera() {
  auto camera = camera_named("400mm");
  camera.diffraction = false;
  camera.glow = 0;  // which the ramp would have all over it
  camera.sensor.response = "colorimetric";
  return camera;
}

Bracketed bracketed(const Exposure& exposure, std::uint64_t seed) {
  const auto one = camera();
  const auto photograph =
      photographed(ramp(), WorkingSpace::linear_rec709, one,
                   {exposure, one.sensor.pixel_um * 1e-3 / one.optics.focal_length_mm, 0, seed, 0});
  return {photograph.scene_linear, photograph.valid,
          exposure.time_s / (exposure.f_number * exposure.f_number)};
}

TEST(Merged, IsTheScenesLuminanceWithinItsNoise) {
  const std::vector<double> times{1. / 500, 1. / 30, 0.5, 4};
  std::vector<Bracketed> set;
  for (const double time : times) set.push_back(bracketed({time, 5.6, 800}, 3 + set.size()));
  const auto result = merged(set);
  const auto scene = ramp();
  const double per_second = electrons_per_cd_m2(camera(), {1, 5.6, 800});
  int dark = 0;
  for (std::size_t c = 0; c < side; ++c) {
    double mean = 0, electrons = 0;
    const double light = scene(0, c)[1];
    for (std::size_t r = 0; r < side; ++r) mean += result.scene_linear(r, c)[1] / side;
    for (std::size_t i = 0; i < set.size(); ++i)
      if (set[i].valid(0, c) == 1) electrons += times[i] * per_second * light;
    ASSERT_GT(electrons, 0) << light;
    // photons' noise, and 8 electrons of read noise at most a photograph, weighted as its light
    const double error = light / electrons * std::sqrt(electrons + 64.) / std::sqrt(side);
    EXPECT_WITHIN(mean, light, 4.5 * error, "four and a half standard errors in 200 columns");
    dark += error > 0.01 * light;
  }
  EXPECT_LT(dark, 100);  // most are known to a hundredth
}

TEST(Merged, IsQuieterThanAnyOfIt) {
  const std::vector<Bracketed> set{bracketed({1, 5.6, 800}, 1), bracketed({1, 5.6, 800}, 2)};
  const auto result = merged(set);
  double one = 0, both = 0;
  const auto scene = ramp();
  for (std::size_t i = 0; i < 16000; ++i) {
    const std::size_t r = i % side, c = i / side;
    one += std::pow(set[0].scene_linear(r, c)[1] - scene(r, c)[1], 2);
    both += std::pow(result.scene_linear(r, c)[1] - scene(r, c)[1], 2);
  }
  EXPECT_WITHIN_RELATIVE(both / one, 0.5, 0.05, "two variances of 16000 pixels, 4 standard errors");
}

TEST(Merged, OfWhatAllClipIsTheDarkestsSaturation) {
  std::vector<Bracketed> set{bracketed({4, 5.6, 800}, 1), bracketed({2, 5.6, 800}, 2)};
  const auto result = merged(set);
  EXPECT_EQ(result.valid(0, side - 1), 0);
  EXPECT_EQ(result.scene_linear(0, side - 1), set[1].scene_linear(0, side - 1));
}

TEST(Merged, RefusesWhatIsNoSet) {
  EXPECT_THROW(merged({}), algebra::Error);
  auto one = bracketed({1, 8, 100}, 1);
  auto small = one;
  small.valid = algebra::Grid<float>(1, 1);
  const std::vector<Bracketed> unlike{one, small};
  EXPECT_THROW(merged(unlike), algebra::Error);
  one.light = 0;
  EXPECT_THROW(merged({&one, 1}), algebra::Error);
}

}  // namespace coppermoon::colour::bracket_test
