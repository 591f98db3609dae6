// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>

#include "texture/openimageio/colour_profile.h"
#include "texture/openimageio/oiio.h"

namespace coppermoon::texture {

/// Properties of a file's stored numbers that OpenImageIO ignores.
struct Storage {
  int orientation = 1;         ///< EXIF's: 1 upright, 2 to 4 flipped or turned, 5 to 8 on a side
  bool white_is_zero = false;  ///< black is the largest number
  std::optional<double> no_data{};  ///< GDAL's: in the file's own numbers
  /// Without: Rec. 709, with sRGB's curve or as curve_of says
  std::optional<ColourProfile> colours{};

  bool on_its_side() const { return orientation >= 5; }
};

/// Properties by the header of an open image.
///
/// Throws  Error  with the path and the tag's name, where what it says can not be heeded: photometric
///                interpretations but grey, colours of light, palettes and CMYK; a page that is a
///                thumbnail; a raw file that ends in .tif; a transfer function; primaries in a TIFF
///                other than Rec. 709; GDAL's offset; a broken profile; the curves of PQ and HLG
Storage storage_of(const std::filesystem::path& path, const OIIO::ImageInput& input);

/// Turns and flips texels by EXIF's orientation.
///
/// Given  stored   [row][column][channel], of that width and height
///        turned   as many numbers; of an image on its side width and height change places
void turn_upright(std::span<const float> stored, std::size_t width, std::size_t height,
                  int orientation, std::span<float> turned);

}  // namespace coppermoon::texture
