// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <glm/mat3x3.hpp>
#include <optional>

#include "texture/image.h"
#include "texture/openimageio/oiio.h"

namespace coppermoon::texture {

/// Whether a file's name has an extension that LibRaw reads: .dng, .cr2, .NEF, …
bool has_raw_ending(const std::filesystem::path& path);

/// Whether an image is a camera's raw file.
bool is_raw(const OIIO::ImageInput& input);

/// Settings that OpenImageIO gets before it opens a file; they affect only raw files. With them, a raw file gives the
/// camera's own three channels, upright and linear, interpolated linearly from the mosaic of its filters. Black is
/// subtracted, and noise below it is cut off. White under D65 is neutral, whatever the camera's white balance was; 1 is
/// white at the saturation of the most sensitive channel.
OIIO::ImageSpec raw_hints();

/// Converts a raw file's channels to linear Rec. 709, by `given` or, if absent, by the camera's colour matrix for D65.
/// A pixel becomes white, 1, if one of its channels is clipped, or if this is so for a neighbour from which it may be
/// interpolated. No number is above 1; colours outside the gamut have numbers below 0.
///
/// Throws  Error  when `given` is absent and no colour matrix of the camera is known
void make_rec709(const std::filesystem::path& path, const OIIO::ImageSpec& spec,
                 const std::optional<glm::dmat3>& given, Image& camera);

}  // namespace coppermoon::texture
