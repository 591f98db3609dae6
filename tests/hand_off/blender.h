// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <glm/matrix.hpp>

#include "almanac/instant.h"
#include "almanac/observer.h"
#include "end_to_end/program.h"
#include "povray_scenes/camera.h"
#include "texture/image.h"
#include "texture/read_image.h"
#include "texture/write_image.h"

namespace coppermoon::hand_off {

inline constexpr std::size_t side = 300;  ///< of a frame [pixels]
inline constexpr double field_deg = 0.6;

/// Who looks, when, and how the camera is held.
struct Look {
  std::string instant;
  almanac::Observer observer;
  povray_scenes::Up up;

  almanac::SkyState sky() const { return almanac::sky_at(almanac::instant_from_utc(instant)); }
  almanac::ObserverView view() const { return almanac::view_from(observer, sky()); }
  povray_scenes::Camera camera() const {
    return povray_scenes::camera_at(sky(), view(), up, {algebra::degrees(field_deg), side, side});
  }
};

/// High in the sky, near the middle of an eclipse.
inline Look from_the_north(povray_scenes::Up up) {
  return {"2008-02-21T03:26:05Z", {algebra::degrees(42.86), algebra::degrees(-73.77), {}}, up};
}
inline Look from_the_south(povray_scenes::Up up) {
  return {"2018-07-27T22:40:00Z", {algebra::degrees(-33.9), algebra::degrees(18.4), {}}, up};
}

inline std::string at(const almanac::Observer& observer) {
  return fmt::format("{},{}", in_degrees(observer.latitude), in_degrees(observer.longitude));
}

inline std::string word(povray_scenes::Up up) {
  using enum povray_scenes::Up;
  return up == zenith ? "zenith" : up == moon_north ? "moon-north" : "celestial-north";
}

/// What the header of a texture says of who looks, computed here.
inline texture::Attributes header(const Look& look) {
  const auto sky = look.sky();
  const auto view = look.view();
  const auto degrees = [](algebra::Angle angle) { return static_cast<float>(in_degrees(angle)); };
  const auto pole = glm::transpose(sky.selenographic_from_gcrs) * glm::dvec3(0, 0, 1);
  return {{"coppermoon:colour_space", std::string("lin_rec709")},
          {"coppermoon:sub_observer_latitude", degrees(view.sub_observer.latitude)},
          {"coppermoon:sub_observer_longitude", degrees(view.sub_observer.longitude)},
          {"coppermoon:axis_position_angle",
           degrees(almanac::position_angle(sky.moon_m - view.position_m, pole, view.north))},
          {"coppermoon:distance_km", static_cast<float>(in_metres(view.moon_distance) / 1000)},
          {"coppermoon:parallactic_angle", degrees(view.parallactic_angle)}};
}

/// Runs Blender without a screen, examples/blender/eclipse.py in it.
class BlenderTest : public end_to_end::ProgramTest {
 protected:
  static std::string project(const std::string& path) {
    return std::string(COPPERMOON_TEST_DATA "/../") + path;
  }

  end_to_end::Outcome eclipse_py(const std::vector<std::string>& words) const {
    const auto outcome = run(blender(words));
    EXPECT_NE(outcome.status, 127) << "blender: not found; tests/hand_off.sh installs it";
    return outcome;
  }

  /// As eclipse_py renders it.
  texture::Image rendered(const std::string& texture, povray_scenes::Up up,
                          std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {texture, "--render", "frame.exr"});
    expect_rendered(up, std::move(more));
    return texture::read_image(here("frame.exr"));
  }

  void expect_rendered(povray_scenes::Up up, std::vector<std::string> words) const {
    const auto size = std::to_string(side);
    const std::vector<std::string> view{"--up",     word(up), "--width", size,
                                        "--height", size,     "--field", std::to_string(field_deg)};
    words.insert(words.end(), view.begin(), view.end());
    const auto outcome = eclipse_py(words);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
  }

  std::string configuration = {};  ///< of OpenColorIO; empty: Blender's own

 private:
  std::vector<std::string> blender(const std::vector<std::string>& words) const {
    std::vector<std::string> all{"env", "-u", "OCIO"};
    if (!configuration.empty()) all.push_back("OCIO=" + configuration);
    const std::vector<std::string> line{"blender", "-b", "--python-exit-code",
                                        "3",       "-P", project("examples/blender/eclipse.py"),
                                        "--"};
    all.insert(all.end(), line.begin(), line.end());
    all.insert(all.end(), words.begin(), words.end());
    return all;
  }
};

}  // namespace coppermoon::hand_off
