// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "texture/image.h"

namespace coppermoon::texture {

/// Encodes a developed picture as a PNG, for a globe in a viewer's file.
///
/// Given   path  of the viewer's file, for errors
///         bits  8 or 16
/// Throws  Error  when values are outside 0 to 1, the shape is not 2:1, channels are not 1 or 3, or the width is
///                above most_glb_columns
std::string picture_on_globe(const std::filesystem::path& path, const Image& image, int bits = 8);

}  // namespace coppermoon::texture
