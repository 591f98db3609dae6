// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <glm/mat3x3.hpp>
#include <optional>

#include "texture/image.h"
#include "texture/openimageio/oiio.h"

namespace coppermoon::texture {

/// Whether LibRaw reads files whose names end so: .dng, .cr2, .NEF, …
bool has_raw_ending(const std::filesystem::path& path);

/// Whether an image is a camera's raw file.
bool is_raw(const OIIO::ImageInput& input);

/// Settings that OpenImageIO gets before it opens a file; only raw files heed them. A raw file gives
/// the camera's own three channels, upright and linear, interpolated linearly from the mosaic of its
/// filters. Black is subtracted, noise below it cut off. D65's white is neutral, whatever white balance
/// the camera was set to; 1 is its saturation, where the most sensitive channel ends.
OIIO::ImageSpec raw_hints();

/// Makes linear Rec. 709 of the channels that a raw file gives, by the camera's colour matrix for D65,
/// or by one that is given. A
/// pixel is white, 1, where a channel of it or of a neighbour that it may be interpolated from is clipped.
/// No number is above 1; those of colours outside the gamut are below 0.
///
/// Throws  Error  when no colour matrix of the camera is known
void make_rec709(const std::filesystem::path& path, const OIIO::ImageSpec& spec,
                 const std::optional<glm::dmat3>& given, Image& camera);

}  // namespace coppermoon::texture
