// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "povray_scenes/moon_scene.h"

namespace coppermoon::povray_scenes {

/// Names of the files for Mitsuba. They are in the same folder as the texture.
inline constexpr const char* mitsuba_file = "eclipse.xml";
inline constexpr const char* mesh_file = "moon.obj";

/// The scene for Mitsuba 3, as XML text in Moon-fixed axes. The Moon only emits light, so that a frame rendered by one
/// of Mitsuba's RGB variants (`mitsuba -m scalar_rgb -o frame.exr eclipse.xml`) has the texture's own values [cd/m²].
///
/// Throws  Error  in the same cases as to_pov
std::string to_mitsuba(const MoonScene& scene);

/// The Moon as a mesh for Mitsuba, in Wavefront OBJ with texture coordinates. Mitsuba's own spheres are always round,
/// but this mesh is flattened as the camera requires.
///
/// Accuracy  deviates from a smooth surface by at most 7.5e-5 of the radius
/// Throws    Error  in the same cases as to_pov
std::string mitsuba_mesh(const MoonScene& scene);

/// Throws an Error if a folder's eclipse.xml or moon.obj is a link, or was changed since the program wrote it.
void require_mitsuba_place(const std::filesystem::path& folder);

/// Writes eclipse.xml and moon.obj, each completely or not at all, as write_scene does for POV-Ray's files.
///
/// Throws  Error  in the same cases as write_scene
void write_mitsuba_scene(const std::filesystem::path& folder, const MoonScene& scene);

}  // namespace coppermoon::povray_scenes
