// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <filesystem>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "povray_scenes/scene_camera.h"

namespace coppermoon::povray_scenes {

/// Names of the files in a scene's folder, which also contains the texture.
inline constexpr const char* scene_file = "eclipse.pov";
inline constexpr const char* settings_file = "eclipse.ini";
inline constexpr const char* frame_file = "frame.exr";

/// A star or planet in front of a camera.
struct SkyLight {
  glm::dvec3 direction;                   ///< unit vector in Moon-fixed axes
  std::array<double, 3> illuminance_lux;  ///< linear Rec.709, on a surface that faces the light
  double radius_rad = 0;                  ///< radius of a planet's disc; 0 for a star
};

/// The light of the air in front of the Moon and the stars, as an .exr in the scene's folder. The texel in column c and
/// row r is for the frame's pixel (c step, r step); between texels, the light is interpolated linearly.
struct AirBefore {
  std::string image;
  std::size_t columns = 2, rows = 2, step = 1;
};

/// A textured Moon with radius 1 in front of a black sky. The Moon emits the light of its texture, so that the frame
/// has the texture's unit (cd/m²) and primaries, scene-linear.
struct MoonScene {
  SceneCamera camera;
  std::string texture;  ///< plain ASCII name of an .exr in the scene's folder
  /// Stars and planets behind the Moon. Each is an emitting sphere with the radius of a pixel, or with that of the
  /// planet if it is larger. If two spheres overlap, one of them hides the other.
  std::vector<SkyLight> lights = {};
  std::optional<AirBefore> air = {};  ///< light of the air, for POV-Ray only
  bool alpha = false;  ///< whether to add a channel A, the share of each pixel covered by the Moon
};

/// The text of a scene for POV-Ray, which needs no include files.
///
/// The Moon-fixed axes X, Y, Z are POV-Ray's x, z, y, because its axes are left-handed. Flattening by the air is
/// applied to the sphere; the texture is not changed. The light of the air is a pane near the camera that absorbs 0.1 %
/// of the light behind the pane.
/// Accuracy  POV-Ray reads the texture and writes the frame as half floats. Their error is 5e-4 of values above 6.1e-5,
///           and 3e-8 below 6.1e-5; values above 65504 become infinite
/// Throws    Error  if require_sound rejects the camera, or the texture's name is not plain ASCII ending in .exr
std::string to_pov(const MoonScene& scene);

/// The text of POV-Ray's settings: size, file names and anti-aliasing. The threshold for anti-aliasing is 0, because
/// POV-Ray compares absolute values, which are small in the dark; the gamma for anti-aliasing is 1, which saves time.
/// There is no jitter, so that frames can be reproduced exactly. No range of frames is set, because POV-Ray's clock is
/// NaN if the range is a single frame.
///
/// Throws  Error  in the same cases as to_pov
std::string to_ini(const MoonScene& scene);

/// Throws an Error if a folder's eclipse.pov or eclipse.ini is a link, or was changed since the program wrote it. A
/// folder without these files is accepted.
void require_scene_place(const std::filesystem::path& folder);

/// Writes eclipse.pov and eclipse.ini, each completely or not at all. When the texture is in the same folder, `povray
/// eclipse.ini` renders frame.exr there. The last line of each file is a fingerprint that reveals later changes.
///
/// Given   folder  created unless it exists; the folder that contains it must exist
/// Throws  Error   in the same cases as to_pov, before anything is written; or if a folder or file cannot be created
void write_scene(const std::filesystem::path& folder, const MoonScene& scene);

}  // namespace coppermoon::povray_scenes
