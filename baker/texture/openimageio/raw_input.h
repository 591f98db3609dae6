// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <glm/mat3x3.hpp>
#include <optional>

#include "texture/image.h"
#include "texture/openimageio/oiio.h"

namespace coppermoon::texture {

/// Whether a file's name ends like those that LibRaw reads: .dng, .cr2, .NEF, …
bool has_raw_ending(const std::filesystem::path& path);

/// Whether an image is a camera's raw file.
bool is_raw(const OIIO::ImageInput& input);

/// Settings that OpenImageIO gets before it opens a file; they affect only raw files. A raw file gives
/// the camera's own three channels, upright and linear, interpolated linearly from the mosaic of its
/// filters. Black is subtracted, and noise below it cut off. D65 white is neutral, whatever the camera's white
/// balance was; 1 is white at the saturation of the most sensitive channel.
OIIO::ImageSpec raw_hints();

/// Converts a raw file's channels to linear Rec. 709, by `given` or else by the camera's colour matrix for D65. A
/// pixel becomes white, 1, if one of its channels is clipped, or one in a neighbour that it may be interpolated from.
/// No number is above 1; colours outside the gamut have numbers below 0.
///
/// Throws  Error  when no colour matrix of the camera is known
void make_rec709(const std::filesystem::path& path, const OIIO::ImageSpec& spec,
                 const std::optional<glm::dmat3>& given, Image& camera);

}  // namespace coppermoon::texture
