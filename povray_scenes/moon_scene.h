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

/// Names of the files in a scene's folder, beside the texture.
inline constexpr const char* scene_file = "eclipse.pov";
inline constexpr const char* settings_file = "eclipse.ini";
inline constexpr const char* frame_file = "frame.exr";

/// A star or planet in front of a camera.
struct SkyLight {
  glm::dvec3 direction;                   ///< unit vector in Moon-fixed axes
  std::array<double, 3> illuminance_lux;  ///< linear Rec.709, on a surface that faces it
  double radius_rad = 0;                  ///< of a planet's disc; 0 for a star
};

/// The light of the air in front of the Moon and the stars, as an .exr in the scene's folder. The texel in column c and
/// row r is for the frame's pixel (c step, r step); between texels, light is interpolated linearly.
struct AirBefore {
  std::string image;
  std::size_t columns = 2, rows = 2, step = 1;
};

/// A textured Moon with radius 1 before a black sky. The texture is emission, so the frame has the texture's unit
/// (cd/m²) and primaries, scene-linear.
struct MoonScene {
  SceneCamera camera;
  std::string texture;  ///< an .exr in the scene's folder: a plain ASCII file name
  /// Stars and planets behind the Moon. Each is an emitting sphere with the radius of a pixel, or of the planet if that
  /// is larger. If two are closer together than that, one hides the other.
  std::vector<SkyLight> lights = {};
  std::optional<AirBefore> air = {};  ///< for POV-Ray only
  bool alpha = false;  ///< adds a channel A: the share of each pixel that the Moon covers
};

/// The text of the scene for POV-Ray, without include files.
///
/// The Moon-fixed X, Y, Z are POV-Ray's x, z, y, since its axes are left-handed.
/// The camera's flattening is applied to the sphere; the texture itself is left alone.
/// The air is a pane near the camera that absorbs 0.1 % of the light behind it.
/// Accuracy  POV-Ray reads the texture and writes the frame as half floats: 5e-4 relative above
///           6.1e-5, 3e-8 absolute below that; values above 65504 are infinite
/// Throws    Error  if the camera is not sound, or the texture's name is not plain ASCII that ends in .exr
std::string to_pov(const MoonScene& scene);

/// The text of POV-Ray's settings: size, file names and anti-aliasing. The anti-aliasing's threshold is 0, because
/// POV-Ray compares absolute values, which are small in the dark. Its gamma is 1, which saves time. There is no jitter,
/// so that frames repeat exactly. There is no range of frames either, because POV-Ray's clock is NaN in a range of one.
///
/// Throws  Error  like to_pov
std::string to_ini(const MoonScene& scene);

/// Refuses a folder whose eclipse.pov or eclipse.ini is a link, or was changed since the program wrote it. A folder
/// without these files passes.
///
/// Throws  Error
void require_scene_place(const std::filesystem::path& folder);

/// Writes eclipse.pov and eclipse.ini, each whole or not at all. Once the texture is beside them, `povray eclipse.ini`
/// in that folder renders frame.exr. The last line of each is a fingerprint that reveals later changes.
///
/// Given   folder  created if only its last part is missing
/// Throws  Error   like to_pov, before anything is written; or if the folder or a file cannot be made
void write_scene(const std::filesystem::path& folder, const MoonScene& scene);

}  // namespace coppermoon::povray_scenes
