// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "texture/image.h"

namespace coppermoon::texture {

/// The widest picture that viewers of glTF and USDZ can be expected to show.
inline constexpr std::size_t most_glb_columns = 8192;

/// What the texels in a .glb hold.
enum class GlbTexels {
  developed,  ///< display-referred: sRGB-coded, 0 to 1
  luminance   ///< scene-linear, linear Rec.709 [cd/m²]
};

/// Writes the Moon as one binary glTF 2.0 file, whole or not at all: the sphere from sphere_mesh, of radius
/// 1, with the picture on it as a PNG inside the file. The same input gives the same bytes.
///
/// A developed material shines by itself (KHR_materials_unlit, the picture as base colour). For viewers
/// without that extension the picture is also the emission: with their lights off it looks the same, and
/// lights add what a white-lit Moon would reflect.
///
/// A material in cd/m² is black and emits light (KHR_materials_emissive_strength): its picture, a 16-bit sRGB-coded
/// PNG, times the luminance of the brightest channel in any texel.
///
/// Given   image      grey or RGB; plate carrée, longitude 0 in the middle, north up, 2:1 to within a texel, up to
///                    most_glb_columns wide
///         generator  name and version of the program; stored along with the Moon's true radius [m]
/// Accuracy           in cd/m²: half a step of the code. In the dark that is 6e-7 of the brightest value; for a
///                    texel with a hundredth of the brightest value it is 1.2e-4 of its own, and less for
///                    brighter ones. Values below 0, as for reds outside Rec.709, become 0
/// Throws  Error      when developed values are outside 0 to 1, luminances are not finite, the shape or number of
///                    channels is another, or the file cannot be written
/// Source  Khronos glTF 2.0.1, KHR_materials_unlit, KHR_materials_emissive_strength
void write_glb(const std::filesystem::path& path, const Image& image, const std::string& generator,
               GlbTexels texels = GlbTexels::developed);

}  // namespace coppermoon::texture
