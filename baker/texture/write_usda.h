// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace coppermoon::texture {

/// Writes a text file of USD (.usda), whole or not at all, that puts a scene-linear texture on
/// sphere_mesh's sphere of radius 1: the default prim `Moon`, Y up, one metre a unit. The ground
/// shines and reflects nothing, by UsdPreviewSurface and by MaterialX's standard surface. The
/// layer's customLayerData hold the Moon's true radius [m].
///
/// Given   texture_file_name  in the same folder: no path
///         colour_space       the texture's, lin_rec709_scene or lin_ap1_scene
///         preview_file_name  of linear Rec.709 in the same folder, for the preview surface, which
///                            knows no colour spaces; empty: the texture, which is right with the
///                            first
///         observer           prims of usd_observer, within Moon; empty: none
/// Throws  Error              another colour space; a file name that is a path, empty, or has control
///                            characters; a file that cannot be written
/// Source  OpenUSD: UsdGeomMesh, UsdPreviewSurface 2.6, GfColorSpaceNames; MaterialX 1.38
void write_usda(const std::filesystem::path& path, const std::string& texture_file_name,
                std::string_view colour_space, const std::string& preview_file_name = {},
                const std::string& observer = {});

}  // namespace coppermoon::texture
