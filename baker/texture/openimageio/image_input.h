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

/// The first line of OpenImageIO's error message. The message must always be fetched, or OpenImageIO prints it at exit.
std::string reason_of(OIIO::ImageInput* input);

/// Whether a file is an OpenEXR file, judged by its first bytes.
bool has_openexr(const std::filesystem::path& path);

/// Opens an image after checking that its header is plausible.
///
/// Throws  Error  as for read_image
std::unique_ptr<OIIO::ImageInput> opened(const std::filesystem::path& path);

/// Whether an image is an OpenEXR file. Channel names and windows are read only from such files. The position on a page
/// in a PNG or TIFF file is not a window.
bool is_openexr(const OIIO::ImageInput& input);

/// Data window (the area that has texels) and display window (the area of the picture) of an OpenEXR image. In other
/// formats, both are the whole image.
Windows windows_of(const OIIO::ImageInput& input);

/// Consecutive rows of an image, with all its channels.
template <class T>
struct RowsRead {
  std::size_t first_row, rows;
  std::vector<T> values;
};

/// Calls `act` with about 64 rows of an image at a time, to save memory. A tiled image is read in whole rows of tiles.
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
    if (!read || input.has_error())  // a TIFF or JPEG that ends early is read, but with an error
      throw cannot_read(path, reason_of(&input));
    act(band);
  }
}

}  // namespace coppermoon::texture
