// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "texture/image.h"

namespace coppermoon::texture {

/// Writes the Moon as one USD package (.usdz), whole or not at all, for viewers and telephones that read no EXR:
/// sphere_mesh's sphere of radius 1 with the picture on it, an 8-bit PNG. The ground shines and reflects nothing, by
/// UsdPreviewSurface. The same input gives the same bytes.
///
/// Given   developed  as write_glb takes it
/// Throws  Error      as write_glb
/// Source  OpenUSD: Usdz File Format 1.3 (a ZIP archive, its files stored as they are from multiples of 64 bytes on, the
///         layer first); PKWARE APPNOTE 6.3
void write_usdz(const std::filesystem::path& path, const Image& developed);

}  // namespace coppermoon::texture
