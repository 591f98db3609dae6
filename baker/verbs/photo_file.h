// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "colour/exposure.h"
#include "texture/image.h"

namespace coppermoon::verbs {

/// A photograph's light: linear, 1 saturates.
///
/// Given  coding  as-file-says, srgb or linear
texture::Image read_photo(const std::string& photo, const std::string& coding);

/// What its header says of how the camera was set; nothing when it does not say all of it.
std::optional<colour::Exposure> exif_of(const std::string& photo);

}  // namespace coppermoon::verbs
