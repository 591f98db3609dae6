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
  bool white_is_zero = false;  ///< whether 0 is white and the largest number black
  std::optional<double> no_data{};  ///< GDAL's value for no data, in the file's own numbers
  /// If absent, Rec. 709, with sRGB's curve or as curve_of says
  std::optional<ColourProfile> colours{};

  bool on_its_side() const { return orientation >= 5; }
};

/// Reads these properties from the header of an open image.
///
/// Throws  Error  with the path and the tag's name, for what cannot be honoured: photometric
///                interpretations other than grey, RGB, palettes and CMYK; a page that is a
///                thumbnail; a raw file named .tif; a transfer function; primaries in a TIFF
///                other than Rec. 709; GDAL's offset; a broken profile; the curves of PQ and HLG
Storage storage_of(const std::filesystem::path& path, const OIIO::ImageInput& input);

/// Rotates and flips texels according to EXIF's orientation.
///
/// Given  stored   [row][column][channel], of the given width and height
///        turned   as many numbers; if the image is on its side, width and height are swapped
void turn_upright(std::span<const float> stored, std::size_t width, std::size_t height,
                  int orientation, std::span<float> turned);

}  // namespace coppermoon::texture
