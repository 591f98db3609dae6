// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "texture/image.h"

namespace coppermoon::texture {

/// Encodes a display-referred texture of the globe as a PNG, to be embedded in a file for 3D viewers.
///
/// Given   path  path of the file for 3D viewers, for error messages
///         bits  8 or 16
/// Throws  Error  when a value is outside 0 to 1, the shape is not 2:1, the number of channels is not 1 or 3, or the
///                width is above most_glb_columns
std::string picture_on_globe(const std::filesystem::path& path, const Image& image, int bits = 8);

}  // namespace coppermoon::texture
