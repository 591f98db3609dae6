// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace coppermoon::texture {

/// Writes a USD text file (.usda), whole or not at all, that puts a scene-linear texture on the sphere from
/// sphere_mesh, of radius 1. It has the default prim `Moon`, Y up, and one metre per unit. The Moon's material emits
/// light and reflects nothing, both as UsdPreviewSurface and as MaterialX's standard surface. The layer's
/// customLayerData hold the Moon's true radius [m].
///
/// Given   texture_file_name  name of a file in the same folder; not a path
///         colour_space       colour space of the texture, lin_rec709_scene or lin_ap1_scene
///         preview_file_name  texture in linear Rec.709 in the same folder, for the preview surface, which does not
///                            support colour spaces. If empty, texture_file_name is used for it, too, which is right
///                            for lin_rec709_scene
///         observer           text of prims from usd_observer, to be put inside the prim Moon; may be empty
/// Throws  Error              for any other colour space; when a file name is a path, is empty, or has control
///                            characters; when the file cannot be written
/// Source  OpenUSD: UsdGeomMesh, UsdPreviewSurface 2.6, GfColorSpaceNames; MaterialX 1.38
void write_usda(const std::filesystem::path& path, const std::string& texture_file_name,
                std::string_view colour_space, const std::string& preview_file_name = {},
                const std::string& observer = {});

}  // namespace coppermoon::texture
