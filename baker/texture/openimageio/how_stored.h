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
  int orientation = 1;         ///< EXIF: 1 is upright, 2 to 4 flipped or turned, 5 to 8 on its side
  bool white_is_zero = false;  ///< whether 0 is white and the largest number black
  std::optional<double> no_data{};  ///< number in the file that marks missing data (GDAL)
  /// Colour profile; if absent, Rec. 709 with sRGB's curve or the one from curve_of (read_image.cpp) is assumed.
  std::optional<ColourProfile> colours{};

  bool on_its_side() const { return orientation >= 5; }
};

/// Reads the properties in Storage from the header of an open image.
///
/// Throws  Error  when a property cannot be honoured; the message gives the path and the tag's name. Such properties
///                are photometric interpretations other than grey, RGB, YCbCr, palettes and CMYK; a page that is a
///                thumbnail; a raw file named .tif; a transfer function or primaries other than Rec. 709 in a TIFF; an
///                offset from GDAL; a broken colour profile; the curves of PQ and HLG
Storage storage_of(const std::filesystem::path& path, const OIIO::ImageInput& input);

/// Rotates and flips texels according to EXIF's orientation.
///
/// Given  stored  texels of the given width and height, [row][column][channel]
///        turned  receives as many values; width and height are swapped if the stored image is on its side
void turn_upright(std::span<const float> stored, std::size_t width, std::size_t height,
                  int orientation, std::span<float> turned);

}  // namespace coppermoon::texture
