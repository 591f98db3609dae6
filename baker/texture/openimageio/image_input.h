// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "algebra/error.h"
#include "texture/openimageio/oiio.h"
#include "texture/read_image.h"

namespace coppermoon::texture {

algebra::Error cannot_read(const std::filesystem::path& path, std::string_view reason);

/// The first line of OpenImageIO's error message. Always fetch it, or OpenImageIO prints it at exit.
std::string reason_of(OIIO::ImageInput* input);

/// Whether a file is an OpenEXR file, judged by its first bytes.
bool has_openexr(const std::filesystem::path& path);

/// Opens an image, having checked that its header is plausible.
///
/// Throws  Error  as read_image
std::unique_ptr<OIIO::ImageInput> opened(const std::filesystem::path& path);

/// Whether an image is OpenEXR, so that its channel names and windows come from the file. The position of a PNG or
/// TIFF on a page is not a window.
bool is_openexr(const OIIO::ImageInput& input);

/// Where an image's texels are, and where its picture is: OpenEXR's data and display windows. For other
/// kinds of files both are the same.
Windows windows_of(const OIIO::ImageInput& input);

/// Some rows of an image, with all its channels.
template <class T>
struct RowsRead {
  std::size_t first_row, rows;
  std::vector<T> values;
};

/// Reads about 64 rows at a time, in whole rows of tiles if the image is tiled, so that little memory is used.
template <class T>
void for_all_rows(OIIO::ImageInput& input, const std::filesystem::path& path, const auto& act) {
  const auto spec = input.spec();
  constexpr auto type = OIIO::BaseTypeFromC<T>::value;
  const bool tiled = spec.tile_width > 0;
  const int step = tiled ? spec.tile_height * std::max(1, 64 / spec.tile_height) : 64;
  RowsRead<T> band;
  for (int y = 0; y < spec.height; y += step) {
    const int begin = spec.y + y, end = spec.y + std::min(y + step, spec.height);
    band.first_row = static_cast<std::size_t>(y);
    band.rows = static_cast<std::size_t>(end - begin);
    band.values.resize(band.rows * static_cast<std::size_t>(spec.width) *
                       static_cast<std::size_t>(spec.nchannels));
    const bool read = tiled ? input.read_tiles(0, 0, spec.x, spec.x + spec.width, begin, end, 0, 1,
                                               0, spec.nchannels, type, band.values.data())
                            : input.read_scanlines(0, 0, begin, end, 0, 0, spec.nchannels, type,
                                                   band.values.data());
    if (!read || input.has_error())  // of TIFF and JPEG that end early it says both
      throw cannot_read(path, reason_of(&input));
    act(band);
  }
}

}  // namespace coppermoon::texture
