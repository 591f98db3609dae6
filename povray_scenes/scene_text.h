// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <filesystem>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "povray_scenes/moon_scene.h"

namespace coppermoon::povray_scenes {

/// Place and direction of a frame's camera, as text for POV-Ray.
struct CameraText {
  std::string location, sky, look_at;  ///< vectors
  std::string squash;                  ///< nine numbers of a matrix; empty if the disc is round
};
CameraText camera_text(const SceneCamera& camera);

/// The point shown in the middle of the picture, Moon-fixed, in lunar radii.
glm::dvec3 middle(const SceneCamera& camera);

/// An emitting sphere that yields a light's illuminance at the camera.
struct LightSphere {
  glm::dvec3 centre;                      ///< Moon-fixed, in the scene's units
  double radius;                          ///< in the scene's units
  std::array<double, 3> luminance_cd_m2;  ///< linear Rec.709
};
std::vector<LightSphere> light_spheres(const MoonScene& scene);

/// The parts of eclipse.pov that differ between a single scene and a sequence.
struct PovText {
  std::string declarations;            ///< before the camera: whole lines
  std::string location, sky, look_at;  ///< POV-Ray expressions of the camera's vectors
  std::string texture;                 ///< POV-Ray expression of the texture's file name
  std::string flattened;               ///< whole lines inside the sphere: its flattening
  std::string lights = {};             ///< whole lines at the end
};

/// The text of eclipse.pov.
std::string pov_text(const MoonScene& scene, const PovText& text);

/// The text of eclipse.ini.
///
/// Given  output     name of the frame's file
///        animation  whole lines at the end
std::string ini_text(const MoonScene& scene, const std::string& output,
                     const std::string& animation);

/// Throws  Error  like to_pov for a single scene
void require_renderable(const MoonScene& scene);

/// Creates a folder if only the last part of its path is missing.
///
/// Throws  Error
void require_folder(const std::filesystem::path& folder);

/// Writes both files into a folder, which is created if only its last part is missing.
void write_texts(const std::filesystem::path& folder, const std::string& pov,
                 const std::string& ini);

}  // namespace coppermoon::povray_scenes
