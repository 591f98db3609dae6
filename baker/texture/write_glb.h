// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "texture/image.h"

namespace coppermoon::texture {

/// The widest picture that viewers of glTF and USDZ can be expected to show.
inline constexpr std::size_t most_glb_columns = 8192;

/// Values of the texels of a .glb.
enum class GlbTexels {
  developed,  ///< display-referred: sRGB-coded, 0 to 1
  luminance   ///< scene-linear, linear Rec.709 [cd/m²]
};

/// Writes the Moon as one binary glTF 2.0 file, whole or not at all: sphere_mesh's sphere of radius
/// 1 with the picture on it, a PNG inside the file. The same input gives the same bytes.
///
/// A developed material shines by itself (KHR_materials_unlit, the picture as base colour). To viewers
/// without that extension the picture is emission too: with their lights off it looks the same, and
/// lights add what a white-lit Moon would reflect.
///
/// A material in cd/m² is black and emits (KHR_materials_emissive_strength): its picture, an sRGB-coded PNG of 16 bits,
/// times the luminance of the brightest channel of all texels.
///
/// Given   image      grey or RGB; plate carrée, longitude 0 in the middle, north up, 2:1 to a texel, up to
///                    most_glb_columns wide
///         generator  name and version of the program; the Moon's true radius goes with it [m]
/// Accuracy           in cd/m²: half a step of the code, which is 6e-7 of the brightest in the dark, and of a texel
///                    1.2e-4 where it has a hundredth of the brightest, less where it has more; what is below 0, as reds
///                    outside Rec.709 have it, becomes 0
/// Throws  Error      developed values outside 0 to 1, luminances that are not finite, another shape or number of
///                    channels; a file that cannot be written
/// Source  Khronos glTF 2.0.1, KHR_materials_unlit, KHR_materials_emissive_strength
void write_glb(const std::filesystem::path& path, const Image& image, const std::string& generator,
               GlbTexels texels = GlbTexels::developed);

}  // namespace coppermoon::texture
