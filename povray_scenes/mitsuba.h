// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "povray_scenes/scene.h"

namespace coppermoon::povray_scenes {

/// Names of files in a folder for Mitsuba, beside the texture.
inline constexpr const char* mitsuba_file = "eclipse.xml";
inline constexpr const char* mesh_file = "moon.obj";

/// Text of the scene for Mitsuba 3, in the axes of the Moon-fixed frame: emission only, so that the frame of a
/// variant in RGB, as `mitsuba -m scalar_rgb -o frame.exr eclipse.xml` makes it, has the texture's values [cd/m²].
///
/// Returned  XML
/// Throws    Error  as to_pov
std::string to_mitsuba(const MoonScene& scene);

/// Moon's mesh for that scene, as Wavefront OBJ with the texture's places: flattened as the camera has it,
/// for Mitsuba's spheres are round.
///
/// Accuracy  round within 7.5e-5 of the radius
/// Throws    Error  as to_pov
std::string mitsuba_mesh(const MoonScene& scene);

/// Refuses a folder whose eclipse.xml or moon.obj is a link, or was changed since the program wrote it.
///
/// Throws  Error
void require_mitsuba_place(const std::filesystem::path& folder);

/// Writes eclipse.xml and moon.obj, each whole or not at all, as write_scene does for POV-Ray.
///
/// Throws  Error
void write_mitsuba_scene(const std::filesystem::path& folder, const MoonScene& scene);

}  // namespace coppermoon::povray_scenes
