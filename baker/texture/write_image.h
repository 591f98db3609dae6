// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "texture/image.h"

namespace coppermoon::texture {

/// Type of the numbers in a texel. `half` has 11 bits of precision, steps of 6e-8 near 0, and a maximum of 65504.
enum class ExrType { half, floating };

/// Options for an OpenEXR file.
struct ExrOptions {
  ExrType type = ExrType::half;
  bool allow_negative = false;  ///< for colours outside a gamut, which have negative channels
  bool packed = true;           ///< lossless compression: PIZ for half, ZIP for floating
};

/// Writes scene-linear texels to an OpenEXR file, whole or not at all. The same image and attributes give the same
/// bytes, whatever the time and the number of threads.
///
/// Given   image       channels with any names, each of which occurs once
///         attributes  standard ones get their standard types; if `capDate` is absent, the file gets an empty one
/// Throws  Error       when a texel is not a number, infinite, negative or beyond the type's range (the message gives
///                     its place and channel); when the image has no texels; when the file cannot be written
void write_exr(const std::filesystem::path& path, const Image& image, const Attributes& attributes,
               const ExrOptions& options = {});

/// One of several images in an OpenEXR file.
struct Part {
  std::string name;
  Layout layout;
  Rows rows;
  std::vector<std::string> left_out =
      {};               ///< names of the file's attributes that this part leaves out
  Attributes own = {};  ///< attributes that only this part has, or that replace the file's
  std::optional<ExrOptions> options = {};  ///< if absent, the file's options apply to this part
};

/// Writes several images as the parts of one OpenEXR file; otherwise works like the function above. Each part has the
/// file's attributes, except those that it leaves out or replaces by its own.
///
/// Throws  Error  also when there is no part, or when two parts have the same name
void write_exr(const std::filesystem::path& path, std::span<const Part> parts,
               const Attributes& attributes, const ExrOptions& options = {});

/// Writes an OpenEXR file from rows that are computed on demand. Bands of 16 MB or 64 rows, whichever is more, are
/// written while the next band is computed. If computing the rows throws an exception, no file is left.
inline void write_exr(const std::filesystem::path& path, const Layout& layout, const Rows& rows,
                      const Attributes& attributes, const ExrOptions& options = {}) {
  const Part whole{"", layout, rows};
  write_exr(path, {&whole, 1}, attributes, options);
}

/// Writes a tiled OpenEXR file, mip-mapped down to one texel, for renderers. Each texel is the mean over its area. The
/// texture repeats from east to west and is clamped at the poles. Only a quarter of it is held in memory.
///
/// Throws  Error  as for write_exr
void write_mipmapped(const std::filesystem::path& path, const Layout& layout, const Rows& rows,
                     const Attributes& attributes, ExrType type = ExrType::half);

/// Format of a file for a display-referred picture, by OpenImageIO's name: "png", with 8 or 16 bits, or "jpeg", with 8.
struct PictureFormat {
  const char* name = "png";
  int bits = 8;
};

/// Writes a display-referred picture (sRGB-coded, 0 to 1, grey or RGB), whole or not at all. Its rows are made on
/// demand, as for write_exr. 8-bit numbers are dithered as in write_png.
///
/// Given   attributes  written as text to a PNG; in a JPEG, only date and exposure are kept, as EXIF
/// Throws  Error       as for write_png
void write_picture(const std::filesystem::path& path, const Layout& layout, const Rows& rows,
                   const PictureFormat& format, const Attributes& attributes = {});

/// Writes a display-referred image (sRGB-coded, 0 to 1, grey or RGB) to a PNG file, whole or not at all. 8-bit numbers
/// are dithered, so that slow gradients show no steps. The added noise is up to half a step, and is the same at each
/// place in every picture. A value that is a whole number of steps does not change.
///
/// Given   bits        8 or 16
///         attributes  written as text
/// Throws  Error       when a value is outside 0 to 1, the number of channels is not 1 or 3, `bits` is not 8 or 16, or
///                     the file cannot be written
void write_png(const std::filesystem::path& path, const Image& image, int bits,
               const Attributes& attributes = {});

/// Writes numbers from 0 to 1 to a 16-bit TIFF file, whole or not at all. They are linear, not coded for a display.
///
/// Given   attributes  those with standard names for date and exposure are written as EXIF; others are left out
/// Throws  Error       as for write_png
void write_tiff(const std::filesystem::path& path, const Image& image,
                const Attributes& attributes = {});

}  // namespace coppermoon::texture
