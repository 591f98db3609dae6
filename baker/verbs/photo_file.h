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

/// What the header of a frame or photograph says of the scene, under the names that texture::Attributes
/// has: its recipe and moment, what the numbers stand for.
texture::Attributes scene_attributes(const std::string& file);

/// When it was taken, in seconds of a time that goes on evenly; nothing when its header does not say,
/// or a camera's clock was not set.
///
/// Throws  Error  when what it says is no date as "2008:02:21 03:26:05"
std::optional<double> taken_at_s(const std::string& photo);

}  // namespace coppermoon::verbs
