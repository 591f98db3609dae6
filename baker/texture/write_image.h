// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "texture/image.h"

namespace coppermoon::texture {

/// Type of a texel's numbers. `half` has 11 bits of precision, steps of 6e-8 near 0, and a maximum of 65504.
enum class ExrType { half, floating };

/// Options for an OpenEXR file.
struct ExrOptions {
  ExrType type = ExrType::half;
  bool allow_negative = false;  ///< for colours outside a gamut; light is never negative
  bool packed = true;           ///< half with PIZ, floating with ZIP, both without loss
};

/// Writes scene-linear texels to an OpenEXR file, whole or not at all. The same image and
/// attributes give the same bytes, whatever the time and the number of threads.
///
/// Given   image       channels with any names, each once
///         attributes  standard ones get their standard types; if `capDate` is absent, it is left empty
/// Throws  Error       when a texel is not a number, infinite, negative or beyond the type's range,
///                     with its place and channel; when the image has no texels; when the file cannot
///                     be written
void write_exr(const std::filesystem::path& path, const Image& image, const Attributes& attributes,
               const ExrOptions& options = {});

/// One of several images in a file.
struct Part {
  std::string name;
  Layout layout;
  Rows rows;
  std::vector<std::string> left_out =
      {};               ///< attributes of the file that do not apply to this part
  Attributes own = {};  ///< attributes for this part alone, or in place of the file's
  std::optional<ExrOptions> options = {};  ///< for this part; if absent, the file's
};

/// Writes several images to one OpenEXR file, one per part, like the overload above. Each part has the attributes,
/// except those that it leaves out or replaces by its own.
///
/// Throws  Error  also when there is no part, or two have the same name
void write_exr(const std::filesystem::path& path, std::span<const Part> parts,
               const Attributes& attributes, const ExrOptions& options = {});

/// Writes rows that are made on the fly: 16 MB or 64 rows are in memory at a time, and the next are made while these
/// are written. An exception while rows are made ends the writing, and no file is left.
inline void write_exr(const std::filesystem::path& path, const Layout& layout, const Rows& rows,
                      const Attributes& attributes, const ExrOptions& options = {}) {
  const Part whole{"", layout, rows};
  write_exr(path, {&whole, 1}, attributes, options);
}

/// Writes a tiled OpenEXR file, mip-mapped down to one texel, as renderers read textures. Each texel is
/// the mean over its area. The texture wraps east and west and is clamped at the poles. A quarter of it is in memory.
///
/// Throws  Error  as write_exr
void write_mipmapped(const std::filesystem::path& path, const Layout& layout, const Rows& rows,
                     const Attributes& attributes, ExrType type = ExrType::half);

/// File format for a display-referred picture, by OpenImageIO's name: "png", with 8 or 16 bits, or "jpeg", with 8.
struct PictureFormat {
  const char* name = "png";
  int bits = 8;
};

/// Writes a display-referred picture (sRGB-coded, 0 to 1, grey or RGB) whose rows are made on the fly, as for
/// write_exr; whole or not at all. 8-bit numbers are dithered as by write_png.
///
/// Given   attributes  written to PNG as text; in JPEG, only date and exposure are kept, as EXIF
/// Throws  Error       as write_png
void write_picture(const std::filesystem::path& path, const Layout& layout, const Rows& rows,
                   const PictureFormat& format, const Attributes& attributes = {});

/// Writes a display-referred image (sRGB-coded, 0 to 1, grey or RGB) to a PNG file, whole or not at
/// all. 8-bit numbers are dithered, so that a slow gradient shows no steps. The noise is half a step, the
/// same at each place in every picture; a value that is a whole number of steps stays as it is.
///
/// Given   bits        8 or 16
///         attributes  written as text
/// Throws  Error       when values are outside 0 to 1, channels are not 1 or 3, bits are not 8 or 16, or
///                     the file cannot be written
void write_png(const std::filesystem::path& path, const Image& image, int bits,
               const Attributes& attributes = {});

/// Writes numbers from 0 to 1 to a 16-bit TIFF file as they are, not coded for a display; whole or
/// not at all.
///
/// Given   attributes  those that describe the exposure, by their standard names, become EXIF's
/// Throws  Error       as write_png
void write_tiff(const std::filesystem::path& path, const Image& image,
                const Attributes& attributes = {});

}  // namespace coppermoon::texture
