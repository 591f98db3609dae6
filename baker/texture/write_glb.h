// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "texture/image.h"

namespace coppermoon::texture {

/// Width of the widest picture that viewers of glTF and USDZ can be expected to show.
inline constexpr std::size_t most_glb_columns = 8192;

/// What the texels in a .glb file hold.
enum class GlbTexels {
  developed,  ///< display-referred: sRGB-coded, 0 to 1
  luminance   ///< scene-linear, linear Rec.709 [cd/m²]
};

/// Writes the Moon as one binary glTF 2.0 file, whole or not at all: the sphere from sphere_mesh, of radius 1, with the
/// picture on it as a PNG inside the file. The same input gives the same bytes.
///
/// A developed picture is shown without lighting (KHR_materials_unlit, with the picture as base colour). For viewers
/// without that extension, the picture is also the emission. In such viewers the Moon looks the same if all lights are
/// off; if they are on, they add the light that a Moon in white light would reflect.
///
/// Texels in cd/m² are shown by a material that is black and emits light (KHR_materials_emissive_strength): the
/// picture, a 16-bit sRGB-coded PNG, times the largest value that any channel has in any texel.
///
/// Given   image      grey or RGB; plate carrée, longitude 0 in the middle, north up, 2:1 to within a texel, up to
///                    most_glb_columns wide
///         generator  name and version of the program; stored along with the Moon's true radius [m]
/// Accuracy           for texels in cd/m², half a step of the 16-bit code. This is 6e-7 of the brightest value near
///                    black. For a texel with a hundredth of the brightest value, it is 1.2e-4 of the texel's value,
///                    and less for brighter texels. Values below 0, such as for reds outside Rec.709, become 0
/// Throws  Error      when developed values are outside 0 to 1, a luminance is not finite, the shape or the number of
///                    channels is not allowed, or the file cannot be written
/// Source  Khronos glTF 2.0.1, KHR_materials_unlit, KHR_materials_emissive_strength
void write_glb(const std::filesystem::path& path, const Image& image, const std::string& generator,
               GlbTexels texels = GlbTexels::developed);

}  // namespace coppermoon::texture
