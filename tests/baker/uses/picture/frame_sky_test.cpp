// SPDX-License-Identifier: MIT
#include "uses/picture/frame_sky.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "almanac/instant.h"
#include "atmosphere/astronomical_refraction.h"
#include "povray_scenes/scene_camera.h"
#include "support/testing.h"
#include "uses/light/spectral_bands.h"
#include "uses/picture/brightness.h"
#include "uses/picture/camera_request.h"
#include "uses/picture/development.h"
#include "uses/picture/still.h"

namespace coppermoon::uses::frame_sky_test {

constexpr double degree = std::numbers::pi / 180;

const almanac::Observer berlin{algebra::degrees(52.52), algebra::degrees(13.4), {}};

/// Dusk at Berlin: the Sun at −5°, the Moon at 4.5°, in totality.
const LitMoon& dusk() {
  static const auto moon = [] {
    MoonRequest request;
    request.texture_width = 64;
    request.light.wish.tolerance = 0.1;
    return lit_moon(request, almanac::sky_at(almanac::instant_from_utc("2025-09-07T18:11Z")));
  }();
  return moon;
}

ViewRequest landscape() {
  return {.observer = berlin,
          .field_deg = 60,
          .width = 240,
          .height = 160,
          .up = povray_scenes::Up::zenith,
          .aim = povray_scenes::HorizonPlace{algebra::degrees(15), algebra::degrees(130)},
          .stars = {.shown = false}};
}

ViewRequest telescope() {
  return {.observer = berlin, .width = 60, .height = 40, .stars = {.shown = false}};
}

ClearSky law() { return {berlin, dusk().sky, {}, magnitudes_above(dusk())}; }

texture::Image black(const ViewRequest& view) { return {view.width, view.height, {"R", "G", "B"}}; }

/// Frame of the sky alone.
texture::Image sky_of(const ViewRequest& request) {
  const auto view = view_of(request, dusk().sky);
  return completed(black(request), view, dusk().sky, {}, {view, dusk()}).light;
}

void expect_light(const texture::Image& frame, std::size_t row, std::size_t column,
                  const std::array<double, 3>& light, double share) {
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_WITHIN_RELATIVE(frame(row, column, k), light[k], share,
                           "interpolation, and half floats: 5e-4")
        << row << ", " << column;
}

TEST(FrameSky, IsThatOfEachCornersDirectionOfATripod) {
  const auto request = landscape();
  const auto frame = sky_of(request);
  const auto aim = in_sky(request.aim->altitude, request.aim->azimuth),
             right = glm::normalize(glm::cross(aim, glm::dvec3(0, 0, 1))),
             up = glm::cross(right, aim);
  const double pixel = 2 * std::tan(30 * degree) / 240;
  for (const std::size_t row : {0, 80, 130})
    for (const std::size_t column : {0, 120, 239}) {
      const auto to = aim + pixel * (static_cast<double>(column) + 0.5 - 120) * right -
                      pixel * (static_cast<double>(row) + 0.5 - 80) * up;
      if (to.z < 0) continue;
      expect_light(frame, row, column, law().light(glm::normalize(to)), 0.01);
    }
}

TEST(FrameSky, IsThatOfEachCornersDirectionOfATelescope) {
  const auto request = telescope();
  const auto frame = sky_of(request);
  const auto view = view_of(request, dusk().sky);
  const auto seen = almanac::view_from(berlin, dusk().sky);
  const auto sight = povray_scenes::sight_of(view.camera);
  const auto east = glm::normalize(glm::cross(seen.north, seen.zenith));
  for (const std::size_t row : {0, 39})
    for (const std::size_t column : {0, 59}) {
      const auto to = glm::transpose(dusk().sky.selenographic_from_gcrs) *
                      glm::normalize(sight.corner + (double(column) + 0.5) * sight.across +
                                     (double(row) + 0.5) * sight.down);
      // as high as it is without air, and raised as the Moon is
      const auto raised = atmosphere::apparent_altitude(seen.altitude) - seen.altitude,
                 altitude = algebra::radians(std::asin(glm::dot(to, seen.zenith))) + raised;
      const double azimuth =
          std::atan2(glm::dot(to, east), glm::dot(to, glm::cross(seen.zenith, east)));
      expect_light(frame, row, column, law().light(in_sky(altitude, algebra::radians(azimuth))),
                   0.002);
    }
}

TEST(FrameSky, HasNoSeam) {
  const auto frame = sky_of(landscape());
  for (std::size_t r = 1; r < 120; ++r)  // above the horizon
    for (std::size_t c = 1; c < frame.width; ++c)
      for (std::size_t k = 0; k < 3; ++k) {
        const double here = frame(r, c, k);
        EXPECT_WITHIN_RELATIVE(frame(r, c - 1, k), here, 0.02, "0.25 degrees apart")
            << r << " " << c;
        EXPECT_WITHIN_RELATIVE(frame(r - 1, c, k), here, 0.03, "0.25 degrees apart")
            << r << " " << c;
      }
}

TEST(FrameSky, IsHiddenBelowTheHorizon) {
  const auto frame = sky_of(landscape());
  for (std::size_t c = 0; c < frame.width; ++c) EXPECT_EQ(frame(159, c, 1), 0);
  EXPECT_GT(frame(120, 120, 1), 0);
}

TEST(FrameSky, IsBlackFromSpaceAndWhereItIsOff) {
  ViewRequest space = telescope();
  space.observer = {};
  auto off = telescope();
  off.sky_cd_m2 = 0;
  for (const auto& request : {space, off}) {
    const auto frame = sky_of(request);
    EXPECT_EQ(frame.values, black(request).values);
    EXPECT_TRUE(FrameSky(view_of(request, dusk().sky), dusk()).black());
  }
}

TEST(FrameSky, OfALuminanceIsEvenAndWhite) {
  ViewRequest request = telescope();
  request.observer = {};
  request.sky_cd_m2 = 0.25;
  for (const float value : sky_of(request).values) EXPECT_EQ(value, 0.25F);
}

TEST(FrameSky, IsKnownToTheFramesHeader) {
  const auto view = view_of(telescope(), dusk().sky);
  const FrameSky sky(view, dusk());
  const auto frame = sky_of(telescope());
  const double middle = colour::luminance(
      picture_space, std::array<double, 3>{frame(20, 30, 0), frame(20, 30, 1), frame(20, 30, 2)});
  EXPECT_WITHIN_RELATIVE(seen_by(view, sky).sky_cd_m2, middle, 2e-3, "half a pixel, half floats");
}

TEST(FrameSky, OfPassesAddsUp) {
  const auto request = telescope();
  const auto view = view_of(request, dusk().sky);
  texture::Image moon(request.width, request.height, {"R", "G", "B", "A"});
  for (std::size_t i = 0; i < moon.values.size(); ++i) moon.values[i] = i / 4 % 2 == 0 ? 0.5F : 0;
  const auto frame = completed(moon, view, dusk().sky, {}, {view, dusk()});
  const auto alone = sky_of(request), whole = frame.whole();
  for (std::size_t i = 0; i < alone.values.size(); ++i) {
    EXPECT_WITHIN_RELATIVE(frame.sky.values[i], alone.values[i], 5e-4, "half floats");
    EXPECT_WITHIN_RELATIVE(whole.values[i], frame.light.values[i] + frame.sky.values[i], 5e-4,
                           "half floats");
  }
}

TEST(FrameSky, ThroughACameraIsAsBrightAsWithout) {
  const auto light = sky_of(telescope());
  const auto view = view_of(telescope(), dusk().sky);
  auto seen = seen_by(view, {view, dusk()});
  CameraRequest request;
  request.model = "schmidt-cassegrain";
  request.noise = false;
  Development development;
  development.camera = request;
  const auto camera = *camera_of(request);
  auto exposure = exposures_for(development, light, picture_space, seen).shorter;
  exposure.time_s /= 3;  // no channel clips
  const auto taken = photographed(request, camera, {light, picture_space, seen}, exposure);
  for (std::size_t r = 0; r < light.height; ++r)
    for (std::size_t c = 0; c < light.width; ++c)
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_WITHIN(
            taken.scene_linear(r, c)[k], light(r, c, k),
            0.05 * std::abs(light(r, c, k) - seen.sky_cd_m2) + 0.002 * light(r, c, k),
            "5 % of what its colour differs from white glow out of the frame; a step of the "
            "sensor")
            << r << " " << c << " " << k;
}

}  // namespace coppermoon::uses::frame_sky_test
