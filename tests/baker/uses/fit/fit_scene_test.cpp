// SPDX-License-Identifier: MIT
#include "uses/fit/fit_scene.h"

#include "almanac/instant.h"
#include "support/luther_camera.h"
#include "support/testing.h"
#include "uses/fit/lit_bins.h"

namespace coppermoon::uses::fit_scene_test {

/// Luminance under the usual air, summed over places.
struct Sum {
  double light = 0, sunlit = 0;

  void add(const shadow::Lookup& usual, const eclipse::ShadowPlace& place, double bright) {
    std::array<double, 3> xyz{};
    usual.read(place, xyz);
    light += bright * xyz[1];
    sunlit += bright;
  }
  double mean() const { return light / sunlit; }
};

/// Discs with the axis on them, with the direction from which angles about it are counted, and with neither.
TEST(LitBins, StandForAllTheirGround) {
  for (const char* utc : {"2018-07-27T20:40:00Z", "2008-02-21T03:12:00Z", "2000-07-16T13:20:00Z"}) {
    const auto sky = almanac::sky_at(almanac::instant_from_utc(utc));
    MoonRequest moon;
    moon.albedo_map = "built-in";
    moon.texture_width = 1024;
    const auto groundwork = groundwork_of(moon, std::span(&sky, 1));
    const auto scene = fit_scene(moon, groundwork, {}, sky);
    const auto axis = eclipse::shadow_axis(sky);
    std::vector<Sum> all(scene.bins), few(scene.bins);
    for (const auto& ground : scene.grounds)
      all[ground.bin].add(groundwork.usual, eclipse::place_of_ground(axis, sky, ground.ground),
                          ground.sunlit);
    for (const auto& lit : lit_bins(scene, sky).places)
      few[lit.bin].add(groundwork.usual, lit.place, lit.sunlit);
    for (std::size_t b = 0; b < scene.bins; ++b) {
      EXPECT_WITHIN_RELATIVE(few[b].sunlit, all[b].sunlit, 1e-9, "sums of the same");
      EXPECT_WITHIN_RELATIVE(few[b].mean(), all[b].mean(), 0.0015,
                             "light bends by as much over a group of 10 degrees")
          << utc << ", bin " << b;
    }
  }
}

/// What a camera's photograph is compared with is what its filters see.
TEST(FitScene, IsSeenThroughTheResponseOfItsMoon) {
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2018-07-27T20:40:00Z"));
  const auto path = std::filesystem::path(::testing::TempDir()) / "fit_scene_luther.csv";
  std::ofstream(path) << luther_camera();
  const auto scene_by = [&](const char* response) {
    MoonRequest moon;
    moon.response = response;
    moon.texture_width = 256;
    return fit_scene(moon, groundwork_of(moon, std::span(&sky, 1)), {}, sky);
  };
  const auto cie = scene_by("colorimetric"), luther = scene_by(path.c_str()),
             canon = scene_by("canon-eos-600d");
  double apart = 0;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t b = 0; b < cie.weights.columns(); ++b) {
      EXPECT_WITHIN(luther.weights(k, b), cie.weights(k, b), 1e-7 * cie.weights(1, 175),
                    "rounding");
      apart = std::max(apart, std::abs(canon.weights(k, b) - cie.weights(k, b)));
    }
  EXPECT_GT(apart, 0.1 * cie.weights(1, 175));
  for (std::size_t i = 0; i < cie.usual_values.values().size(); ++i)
    EXPECT_WITHIN_RELATIVE(luther.usual_values.values()[i], cie.usual_values.values()[i], 1e-5,
                           "floats");
  std::filesystem::remove(path);
}

/// Filters of a camera that is not known are an error of the light: as far as those of others differ.
TEST(FitScene, KnowsHowOtherCamerasSeeIt) {
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2018-07-27T20:40:00Z"));
  const auto scene_by = [&](const char* response, bool assumed) {
    MoonRequest moon;
    moon.response = response;
    moon.texture_width = 256;
    return fit_scene(moon, groundwork_of(moon, std::span(&sky, 1), assumed), {}, sky);
  };
  const auto assumed = scene_by("canon-eos-600d", true), observer = scene_by("colorimetric", false);
  EXPECT_TRUE(observer.by_filters.empty());
  ASSERT_EQ(assumed.by_filters.size(), 12);  // eleven other cameras and the observer
  for (std::size_t b = 0; b < assumed.bins; ++b)
    for (std::size_t k = 0; k < 2; ++k)  // blue is beyond the gamut in the umbra
      EXPECT_WITHIN(assumed.by_filters.back()(b, k),
                    std::log(observer.usual_values(b, k) / assumed.usual_values(b, k)), 0.03,
                    "pixels are brought into the gamut one by one, bins as a whole; air above");
}

/// At the umbra's edge, light grows so much within a bin that slopes between bins are far off.
TEST(FitScene, KnowsHowLightChangesWithItsPlaceInTheShadow) {
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2018-07-27T21:43:13Z"));
  MoonRequest moon;
  moon.texture_width = 256;
  const auto groundwork = groundwork_of(moon, std::span(&sky, 1));
  const auto scene = fit_scene(moon, groundwork, {}, sky);
  const auto axis = eclipse::shadow_axis(sky);
  for (std::size_t b = 0; b < scene.bins; ++b) {
    std::array<double, 2> light{};
    for (const auto& ground : scene.grounds) {
      if (ground.bin != b) continue;
      auto place = eclipse::place_of_ground(axis, sky, ground.ground);
      for (const std::size_t i : {0, 1}) {
        place.axis_distance = place.axis_distance + algebra::kilometres(i == 0 ? -1 : 4);
        std::array<double, 3> xyz{};
        groundwork.usual.read(place, xyz);
        light[i] += ground.sunlit * xyz[1];
      }
    }
    double luminance = 0, change = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double of_channel = luminance_of_rec709[k] * scene.usual_values(b, k);
      luminance += of_channel;
      change += of_channel * scene.place_slopes(b, k);
    }
    EXPECT_WITHIN(change / luminance, std::log(light[1] / light[0]) / 4, 3e-5,
                  "slopes over 2 and 4 km about one place, the steepest 0.01")
        << "bin " << b;
  }
}

}  // namespace coppermoon::uses::fit_scene_test
