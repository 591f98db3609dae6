// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "povray_scenes/moon_scene.h"

namespace coppermoon::povray_scenes {

/// Names of the files for Mitsuba, which are in the same folder as the texture.
inline constexpr const char* mitsuba_file = "eclipse.xml";
inline constexpr const char* mesh_file = "moon.obj";

/// The text of the scene for Mitsuba 3, as XML, in Moon-fixed axes. The Moon only emits light, so that a frame from an
/// RGB variant, such as `mitsuba -m scalar_rgb -o frame.exr eclipse.xml`, has the texture's own values [cd/m²].
///
/// Throws  Error  like to_pov
std::string to_mitsuba(const MoonScene& scene);

/// The Moon as a mesh for Mitsuba, in Wavefront OBJ with texture coordinates. Mitsuba's own spheres are always round,
/// but this mesh is flattened as much as the camera demands.
///
/// Accuracy  round to within 7.5e-5 of the radius
/// Throws    Error  like to_pov
std::string mitsuba_mesh(const MoonScene& scene);

/// Refuses a folder if its eclipse.xml or moon.obj is a link, or was changed since the program wrote it.
///
/// Throws  Error
void require_mitsuba_place(const std::filesystem::path& folder);

/// Writes eclipse.xml and moon.obj, each whole or not at all, the way write_scene writes POV-Ray's files.
///
/// Throws  Error
void write_mitsuba_scene(const std::filesystem::path& folder, const MoonScene& scene);

}  // namespace coppermoon::povray_scenes
