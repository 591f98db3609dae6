// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "texture/image.h"

namespace coppermoon::texture {

/// The widest picture that viewers of glTF and USDZ can be expected to show.
inline constexpr std::size_t most_glb_columns = 8192;

/// Writes the Moon as one binary glTF 2.0 file, whole or not at all: sphere_mesh's sphere of radius
/// 1 with the picture on it, an 8-bit PNG inside the file. The same input gives the same bytes.
///
/// The material shines by itself (KHR_materials_unlit, the picture as base colour). To viewers
/// without that extension the picture is emission too: with their lights off it looks the same, and
/// lights add what a white-lit Moon would reflect.
///
/// Given   developed  display-referred: sRGB-coded, 0 to 1, grey or RGB; plate carrée, longitude 0
///                    in the middle, north up, 2:1 to a texel, up to most_glb_columns wide
///         generator  name and version of the program; the Moon's true radius goes with it [m]
/// Throws  Error      values outside 0 to 1, another shape or number of channels; a file that cannot
///                    be written
/// Source  Khronos glTF 2.0.1, KHR_materials_unlit
void write_glb(const std::filesystem::path& path, const Image& developed,
               const std::string& generator);

}  // namespace coppermoon::texture
