// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "povray_scenes/moon_scene.h"

namespace coppermoon::povray_scenes {

/// Names of the files for Mitsuba, which stand in one folder with the texture.
inline constexpr const char* mitsuba_file = "eclipse.xml";
inline constexpr const char* mesh_file = "moon.obj";

/// The text of the scene for Mitsuba 3, in Moon-fixed axes. The scene has emission only, so that a frame from an RGB
/// variant, such as `mitsuba -m scalar_rgb -o frame.exr eclipse.xml`, has the texture's own values [cd/m²].
///
/// Returned  XML
/// Throws    Error  like to_pov
std::string to_mitsuba(const MoonScene& scene);

/// The Moon's mesh for that scene, as Wavefront OBJ with texture coordinates. It is flattened as the camera says, since
/// Mitsuba's spheres are always round.
///
/// Accuracy  round to within 7.5e-5 of the radius
/// Throws    Error  like to_pov
std::string mitsuba_mesh(const MoonScene& scene);

/// Refuses a folder whose eclipse.xml or moon.obj is a link, or was changed since the program wrote it.
///
/// Throws  Error
void require_mitsuba_place(const std::filesystem::path& folder);

/// Writes eclipse.xml and moon.obj, each whole or not at all, the way write_scene writes POV-Ray's files.
///
/// Throws  Error
void write_mitsuba_scene(const std::filesystem::path& folder, const MoonScene& scene);

}  // namespace coppermoon::povray_scenes
