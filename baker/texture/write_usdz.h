// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "texture/image.h"

namespace coppermoon::texture {

/// Writes the Moon as one USD package (.usdz), whole or not at all, for viewers and phones that cannot read EXR. It
/// holds the sphere from sphere_mesh, of radius 1, with the picture on it as an 8-bit PNG. The Moon's
/// material is a UsdPreviewSurface that emits light and reflects nothing. The same input gives the same bytes.
///
/// Given   developed  as for write_glb
/// Throws  Error      as for write_glb
/// Source  OpenUSD: Usdz File Format 1.3 (a ZIP archive in which uncompressed files start at multiples of 64 bytes, the
///         layer first); PKWARE APPNOTE 6.3
void write_usdz(const std::filesystem::path& path, const Image& developed);

}  // namespace coppermoon::texture
