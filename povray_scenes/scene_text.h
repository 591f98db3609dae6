// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "povray_scenes/scene.h"

namespace coppermoon::povray_scenes {

/// Where the camera of one frame stands and looks, in POV-Ray's numbers; the same of a single scene
/// and of a frame of a sequence.
struct CameraText {
  std::string location, sky, look_at;  ///< vectors
  std::string squash;                  ///< a matrix's nine numbers; empty: the disc is round
};
CameraText camera_text(const SceneCamera& camera, double moon_radius);

/// What stands in eclipse.pov where a single scene and a sequence differ.
struct PovText {
  std::string declarations;            ///< before the camera: whole lines
  std::string location, sky, look_at;  ///< expressions
  std::string texture;                 ///< an expression: the file's name
  std::string flattened;               ///< whole lines within the sphere
  std::string lights = {};             ///< whole lines at the end
};

/// All of eclipse.pov but for what is handed in `text` is the scene's.
std::string pov_text(const MoonScene& scene, const PovText& text);

/// Given  output     the name of the frame's file
///        animation  whole lines at the end
std::string ini_text(const MoonScene& scene, const std::string& output,
                     const std::string& animation);

/// Throws  Error  as to_pov of a single scene
void require_renderable(const MoonScene& scene);

/// Makes the folder when only its last part is missing, and in it both files.
void write_texts(const std::filesystem::path& folder, const std::string& pov,
                 const std::string& ini);

}  // namespace coppermoon::povray_scenes
