// SPDX-License-Identifier: MIT
#include "povray_scenes/moon_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <string_view>

#include "algebra/error.h"
#include "files/own_file.h"
#include "files/whole_file.h"
#include "povray_scenes/scene_camera.h"
#include "povray_scenes/scene_text.h"

namespace coppermoon::povray_scenes {
namespace {

bool plain_ascii(std::string_view name) {
  constexpr std::string_view special = "\"\\/";
  return std::ranges::all_of(name, [&](char c) {
    return c >= ' ' && c <= '~' && special.find(c) == std::string_view::npos;
  });
}

void require_texture_name(const std::string& name) {
  if (!plain_ascii(name) || name.size() < 5 || !name.ends_with(".exr"))
    throw algebra::Error(fmt::format(
        "texture = '{}', allowed: an ASCII file name in the scene's folder that ends in .exr",
        name));
}

std::string pov_numbers(const glm::dvec3& v) { return fmt::format("{}, {}, {}", v.x, v.z, v.y); }
std::string left_handed(const glm::dvec3& v) { return fmt::format("<{}>", pov_numbers(v)); }

/// The matrix that flattens the Moon, as text for POV-Ray. The matrix is symmetric, so rows can be written as columns.
std::string squash(const SceneCamera& camera) {
  if (camera.flattening == 1) return {};
  const auto m = flattened_by_air(camera);
  return fmt::format("{}, {}, {}, {}, {}, {}, {}, {}, {}", m[0].x, m[0].z, m[0].y, m[2].x, m[2].z,
                     m[2].y, m[1].x, m[1].z, m[1].y);
}

/// The spheres for all stars and planets, as text for POV-Ray.
std::string spheres_text(const MoonScene& scene) {
  std::string text;
  for (const auto& [centre, radius, luminance] : light_spheres(scene))
    text += fmt::format(
        "sphere {{ {}, {} pigment {{ rgb <{:.6g}, {:.6g}, {:.6g}> }} finish {{ ambient 0 diffuse 0 "
        "emission 1 }} }}\n",
        left_handed(centre), radius, luminance[0], luminance[1], luminance[2]);
  return text;
}

/// A pane in front of the camera that emits the air's light, as text for POV-Ray. Its opacity is low, so that the Moon
/// and the stars behind it stay visible. It extends half a texel beyond the frame so that POV-Ray can interpolate.
std::string pane_text(const MoonScene& scene) {
  if (!scene.air) return {};
  const auto& [image, columns, rows, step] = *scene.air;
  const auto sight = sight_of(scene.camera);
  const auto unit = static_cast<double>(step);
  const auto across = unit * static_cast<double>(columns) * sight.across,
             up = -unit * static_cast<double>(rows) * sight.down,
             corner = sight.position + sight.corner - unit / 2 * (sight.across + sight.down) - up;
  return fmt::format(R"(// Light of the air, before Moon and stars.
#declare Opacity = 0.001;  // of a pane that shines through it
polygon {{
  5, <0, 0>, <1, 0>, <1, 1>, <0, 1>, <0, 0>
  pigment {{
    average
    pigment_map {{ [Opacity image_map {{ exr "{}" interpolate 2 once }}] [1 - Opacity rgbt <0, 0, 0, 1>] }}
  }}
  finish {{ ambient 0 diffuse 0 emission 1/(Opacity*Opacity) }}
  matrix <{}, {}, {}, {}>
}}
)",
                     image, pov_numbers(across), pov_numbers(up),
                     pov_numbers(line_of_sight(scene.camera)), pov_numbers(corner));
}

}  // namespace

glm::dvec3 middle(const SceneCamera& camera) {
  if (camera.direction == glm::dvec3(0, 0, 0)) return {0, 0, 0};
  return camera.position + glm::length(camera.position) * line_of_sight(camera);
}

std::vector<LightSphere> light_spheres(const MoonScene& scene) {
  constexpr double pi = std::numbers::pi, most_luminance = 3e4;  // a half float is at most 65504
  const auto& camera = scene.camera;
  // not far behind the Moon, because POV-Ray makes no bounding boxes for objects beyond 1e6 units
  const double away = 2 * glm::length(camera.position);
  const double pixel =
      2 * std::tan(in_radians(camera.horizontal_field) / 2) / static_cast<double>(camera.width);
  std::vector<LightSphere> all;
  for (const auto& light : scene.lights) {
    const auto& lux = light.illuminance_lux;
    const double radius = std::max({std::sin(std::min(pixel, 0.1)), light.radius_rad,
                                    std::sqrt(std::ranges::max(lux) / (pi * most_luminance))});
    const double solid_angle = pi * radius * radius;
    all.push_back({camera.position + away * light.direction,
                   away * radius,
                   {lux[0] / solid_angle, lux[1] / solid_angle, lux[2] / solid_angle}});
  }
  return all;
}

void require_renderable(const MoonScene& scene) {
  require_sound(scene.camera);
  require_texture_name(scene.texture);
  if (scene.air) require_texture_name(scene.air->image);
}

CameraText camera_text(const SceneCamera& camera) {
  return {left_handed(camera.position), left_handed(glm::normalize(camera.up)),
          left_handed(middle(camera)), squash(camera)};
}

std::string pov_text(const MoonScene& scene, const PovText& text) {
  const SceneCamera& camera = scene.camera;
  return fmt::format(
      R"(// The eclipsed Moon
// Emission only: the frame has the texture's own values, scene-linear [cd/m2].
// The Moon-fixed axes X (longitude 0), Y (90 east), Z (north) are x, z, y here.
#version 3.7;
global_settings {{ assumed_gamma 1.0 charset utf8 }}
background {{ {background} }}
{declarations}camera {{
  perspective
  location {location}
  direction z
  right x*{width}/{height}
  up y
  sky {sky}
  angle {field}
  look_at {look_at}
}}
sphere {{
  <0, 0, 0>, 1
  pigment {{ image_map {{ exr {texture} map_type 1 interpolate 2 }} }}
  finish {{ ambient 0 diffuse 0 emission 1 }}
  rotate y*180
{flattened}}}
{lights})",
      fmt::arg("background", scene.alpha ? "rgbt 1" : "rgb 0"),
      fmt::arg("declarations", text.declarations), fmt::arg("location", text.location),
      fmt::arg("width", camera.width), fmt::arg("height", camera.height), fmt::arg("sky", text.sky),
      fmt::arg("look_at", text.look_at), fmt::arg("field", in_degrees(camera.horizontal_field)),
      fmt::arg("texture", text.texture), fmt::arg("flattened", text.flattened),
      fmt::arg("lights", text.lights));
}

std::string ini_text(const MoonScene& scene, const std::string& output,
                     const std::string& animation) {
  return fmt::format(
      R"(; The eclipsed Moon
; In this folder: povray {settings}
Input_File_Name={input}
Output_File_Name={output}
Output_to_File=on
Output_File_Type=E
Output_Alpha={alpha}
Width={width}
Height={height}
Quality=9
Antialias=on
Antialias_Threshold=0.0
Antialias_Gamma=1.0
Sampling_Method=2
Antialias_Depth=2
Jitter=off
Display=off
Pause_When_Done=off
Verbose=on
{animation})",
      fmt::arg("settings", settings_file), fmt::arg("input", scene_file),
      fmt::arg("output", output), fmt::arg("alpha", scene.alpha ? "on" : "off"),
      fmt::arg("animation", animation), fmt::arg("width", scene.camera.width),
      fmt::arg("height", scene.camera.height));
}

void require_folder(const std::filesystem::path& folder) {
  std::error_code failure;
  std::filesystem::create_directory(folder, failure);
  if (!std::filesystem::is_directory(folder, failure))
    throw algebra::Error(fmt::format("{}: cannot be made a folder", folder.string()));
}

void write_texts(const std::filesystem::path& folder, const std::string& pov,
                 const std::string& ini) {
  require_folder(folder);
  files::write_whole(folder / scene_file, files::stamped(pov, "//"));
  files::write_whole(folder / settings_file, files::stamped(ini, ";"));
}

std::string to_pov(const MoonScene& scene) {
  require_renderable(scene);
  const auto camera = camera_text(scene.camera);
  const auto flattened =
      camera.squash.empty() ? "" : fmt::format("  matrix <{}, 0, 0, 0>\n", camera.squash);
  return pov_text(scene, {.declarations = {},
                          .location = camera.location,
                          .sky = camera.sky,
                          .look_at = camera.look_at,
                          .texture = fmt::format("\"{}\"", scene.texture),
                          .flattened = flattened,
                          .lights = spheres_text(scene) + pane_text(scene)});
}

std::string to_ini(const MoonScene& scene) {
  require_renderable(scene);
  return ini_text(scene, frame_file, {});
}

void require_scene_place(const std::filesystem::path& folder) {
  for (const char* file : {scene_file, settings_file}) files::require_stamped(folder / file);
}

void write_scene(const std::filesystem::path& folder, const MoonScene& scene) {
  write_texts(folder, to_pov(scene), to_ini(scene));
}

}  // namespace coppermoon::povray_scenes
