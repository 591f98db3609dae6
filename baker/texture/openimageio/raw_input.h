// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <glm/mat3x3.hpp>
#include <optional>

#include "texture/image.h"
#include "texture/openimageio/oiio.h"

namespace coppermoon::texture {

/// Whether a file's name has the extension of a raw file that LibRaw reads, such as .dng, .cr2 or .NEF.
bool has_raw_ending(const std::filesystem::path& path);

/// Whether an image is a camera's raw file.
bool is_raw(const OIIO::ImageInput& input);

/// Settings for OpenImageIO's reader; they affect only raw files. With them, a raw file is read as the camera's own
/// three channels, upright and linear, interpolated linearly from the mosaic of colour filters. Black is subtracted,
/// and noise below black is cut off. White under D65 is neutral, whatever the camera's white balance was. The value 1
/// is white at the saturation of the most sensitive channel.
OIIO::ImageSpec raw_hints();

/// Converts a raw file's channels to linear Rec. 709 with the matrix `given` or, if it is absent, with the camera's
/// colour matrix for D65. A pixel becomes white, 1, if it has a clipped channel, or if a neighbour from which it may be
/// interpolated has one. No value is above 1; colours outside the gamut have values below 0.
///
/// Throws  Error  when `given` is absent and no colour matrix is known for the camera
void make_rec709(const std::filesystem::path& path, const OIIO::ImageSpec& spec,
                 const std::optional<glm::dmat3>& given, Image& camera);

}  // namespace coppermoon::texture
