// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "povray_scenes/scene.h"

namespace coppermoon::povray_scenes {

/// Place and direction of a frame's camera as POV-Ray's numbers.
struct CameraText {
  std::string location, sky, look_at;  ///< vectors
  std::string squash;                  ///< a matrix's nine numbers; empty: the disc is round
};
CameraText camera_text(const SceneCamera& camera, double moon_radius);

/// Parts of eclipse.pov in which a single scene and a sequence differ.
struct PovText {
  std::string declarations;            ///< before the camera: whole lines
  std::string location, sky, look_at;  ///< POV-Ray expressions of the camera's vectors
  std::string texture;                 ///< POV-Ray expression of the texture's file name
  std::string flattened;               ///< whole lines inside the sphere: its flattening
  std::string lights = {};             ///< whole lines at the end
};

/// Text of eclipse.pov.
std::string pov_text(const MoonScene& scene, const PovText& text);

/// Text of eclipse.ini.
///
/// Given  output     name of the frame's file
///        animation  whole lines at the end
std::string ini_text(const MoonScene& scene, const std::string& output,
                     const std::string& animation);

/// Throws  Error  as to_pov of a single scene
void require_renderable(const MoonScene& scene);

/// Writes both files into a folder, made when only its last part is missing.
void write_texts(const std::filesystem::path& folder, const std::string& pov,
                 const std::string& ini);

}  // namespace coppermoon::povray_scenes
