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
  int orientation = 1;         ///< EXIF: 1 upright, 2 to 4 flipped or turned, 5 to 8 on its side
  bool white_is_zero = false;  ///< whether 0 is white and the largest number black
  std::optional<double> no_data{};  ///< number that marks missing data (GDAL), as in the file
  /// Profile of the file's colours. If absent, they are Rec. 709, with sRGB's curve or the one from curve_of.
  std::optional<ColourProfile> colours{};

  bool on_its_side() const { return orientation >= 5; }
};

/// Reads these properties from the header of an open image.
///
/// Throws  Error  with the path and the tag's name, for what cannot be honoured: photometric interpretations other than
///                grey, RGB, palettes and CMYK; a page that is a thumbnail; a raw file named .tif; a transfer function;
///                primaries other than Rec. 709 in a TIFF; an offset from GDAL; a broken profile; the curves of PQ and
///                HLG
Storage storage_of(const std::filesystem::path& path, const OIIO::ImageInput& input);

/// Rotates and flips texels according to EXIF's orientation.
///
/// Given  stored   [row][column][channel], of the given width and height
///        turned   the result, of the same length; if the image is on its side, width and height are swapped in it
void turn_upright(std::span<const float> stored, std::size_t width, std::size_t height,
                  int orientation, std::span<float> turned);

}  // namespace coppermoon::texture
