// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <filesystem>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "povray_scenes/moon_scene.h"

namespace coppermoon::povray_scenes {

/// A frame's camera as text for POV-Ray.
struct CameraText {
  std::string location, sky, look_at;  ///< vectors in POV-Ray's notation
  std::string squash;                  ///< nine numbers that flatten the disc; empty if it is round
};
CameraText camera_text(const SceneCamera& camera);

/// The point shown in the middle of the picture, in Moon-fixed axes and lunar radii.
glm::dvec3 middle(const SceneCamera& camera);

/// An emitting sphere that gives the illuminance of a star or planet at the camera.
struct LightSphere {
  glm::dvec3 centre;                      ///< in Moon-fixed axes and lunar radii
  double radius;                          ///< in lunar radii
  std::array<double, 3> luminance_cd_m2;  ///< linear Rec.709
};
std::vector<LightSphere> light_spheres(const MoonScene& scene);

/// The parts of eclipse.pov that differ between a single scene and a sequence.
struct PovText {
  std::string declarations;            ///< whole lines that come before the camera
  std::string location, sky, look_at;  ///< POV-Ray expressions for the camera's vectors
  std::string texture;                 ///< POV-Ray expression for the texture's file name
  std::string flattened;               ///< whole lines inside the sphere, which flatten it
  std::string lights = {};             ///< whole lines for stars and planets, at the text's end
};

/// The text of eclipse.pov.
std::string pov_text(const MoonScene& scene, const PovText& text);

/// The text of eclipse.ini.
///
/// Given  output     name of the frame's file
///        animation  whole lines for an animation, at the end of the text
std::string ini_text(const MoonScene& scene, const std::string& output,
                     const std::string& animation);

/// Throws the same errors for a scene as to_pov.
void require_renderable(const MoonScene& scene);

/// Creates a folder unless it exists. Throws an Error if this fails; the folder that contains it must exist.
void require_folder(const std::filesystem::path& folder);

/// Writes eclipse.pov and eclipse.ini into a folder, which require_folder creates.
void write_texts(const std::filesystem::path& folder, const std::string& pov,
                 const std::string& ini);

}  // namespace coppermoon::povray_scenes
