// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <cstdlib>
#include <glm/matrix.hpp>

#include "almanac/instant.h"
#include "almanac/observer.h"
#include "povray_scenes/scene_camera.h"
#include "support/program.h"
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
  povray_scenes::SceneCamera camera() const {
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

/// Runs Blender without a window, with the add-on from its zip, and with nothing of the user's.
class BlenderTest : public ProgramTest {
 protected:
  BlenderTest() {
    const auto addons = here("scripts/addons");
    std::filesystem::create_directories(addons);
    const auto unpacked =
        run(words_of("cmake -E tar xf {}", COPPERMOON_ADD_ON), {.folder = addons});
    EXPECT_EQ(unpacked.status, 0) << unpacked.err;
  }

  static std::string project(const std::string& path) {
    return std::string(COPPERMOON_TEST_DATA "/../") + path;
  }

  /// Blender's command line: `words`, with the program on the PATH.
  Outcome blender(const Words& words) const {
    auto all =
        words_of("env -u OCIO BLENDER_USER_SCRIPTS={} BLENDER_USER_CONFIG={} XDG_CACHE_HOME={}",
                 here("scripts"), here("config"), here("cache"));
    if (!configuration.empty()) all.push_back("OCIO=" + configuration);
    all += surroundings + words;
    const auto programs = std::filesystem::path(COPPERMOON_PROGRAM).parent_path().string();
    const auto outcome = run(all, {.path = programs + ":" + std::getenv("PATH")});
    EXPECT_NE(outcome.status, 127) << "not found; tests/hand_off.sh installs it: " << words.front();
    return outcome;
  }

  /// Runs a Python program in Blender, and then does what the words behind it say.
  Outcome python(const std::string& program, Words more = {}) const {
    return blender(words_of("blender -b --factory-startup --python-exit-code 3 --addons "
                            "coppermoon --python-expr {}",
                            "import bpy\n" + program) +
                   more);
  }

  /// A call of the operator that imports a texture, or a film's folder.
  static std::string import_eclipse(const std::string& texture, povray_scenes::Up up) {
    return fmt::format("bpy.ops.coppermoon.import_eclipse(filepath=r'{}', up='{}', field={:.9f})\n",
                       texture, word(up), in_radians(algebra::degrees(field_deg)));
  }

  /// What makes frames as large as ours.
  static std::string square() {
    return fmt::format(
        "scene = bpy.context.scene\n"
        "scene.render.resolution_x = scene.render.resolution_y = {}\n",
        side);
  }

  /// The frame that Blender renders of a texture, after some more Python.
  texture::Image rendered(const std::string& texture, povray_scenes::Up up,
                          const std::string& more = {}) const {
    return rendered(import_eclipse(texture, up) + square() + more);
  }

  /// The frame of the scene that a Python program makes.
  texture::Image rendered(const std::string& program) const {
    const auto outcome = python(program, words_of("-o {} -f 1", here("frame.####")));
    EXPECT_EQ(outcome.status, 0) << outcome.out;
    return texture::read_image(here("frame.0001.exr"));
  }

  std::string configuration = {};  ///< of OpenColorIO; empty: Blender's own
  Words surroundings = {};         ///< as "A=B"
};

}  // namespace coppermoon::hand_off
