// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "texture/image.h"

namespace coppermoon::texture {

/// Type of a texel's numbers: `half` has 11 bits, steps of 6e-8 near 0, and ends at 65504.
enum class ExrType { half, floating };

/// Options of an OpenEXR file.
struct ExrOptions {
  ExrType type = ExrType::half;
  bool allow_negative = false;  ///< light is never negative, colours outside a gamut are
  bool packed = true;           ///< half with PIZ, floating with ZIP, both without loss
};

/// Writes scene-linear texels to an OpenEXR file, whole or not at all. The same image and
/// attributes give the same bytes, whatever the time and the number of threads.
///
/// Given   image       channels of any names, each once
///         attributes  standard ones get their standard types; without `capDate` that one is empty
/// Throws  Error       a texel that is no number, infinite, negative or beyond the type's range,
///                     with its place and channel; an image without texels; a file that cannot be
///                     written
void write_exr(const std::filesystem::path& path, const Image& image, const Attributes& attributes,
               const ExrOptions& options = {});

/// One image of several in a file.
struct Part {
  std::string name;
  Layout layout;
  Rows rows;
  std::vector<std::string> left_out =
      {};               ///< attributes of the file that are not true of this part
  Attributes own = {};  ///< attributes of this part alone, or in place of the file's
  std::optional<ExrOptions> options = {};  ///< of this part; without: the file's
};

/// Several images in one OpenEXR file of as many parts, as above; the attributes stand in each,
/// but for those that it leaves out or has of its own.
///
/// Throws  Error  also when there is none, or two have one name
void write_exr(const std::filesystem::path& path, std::span<const Part> parts,
               const Attributes& attributes, const ExrOptions& options = {});

/// Writes rows that are made meanwhile: 16 MB or 64 rows are in memory at a time, and the next are made while they are
/// written. An exception while making them ends the writing, and no file is left.
inline void write_exr(const std::filesystem::path& path, const Layout& layout, const Rows& rows,
                      const Attributes& attributes, const ExrOptions& options = {}) {
  const Part whole{"", layout, rows};
  write_exr(path, {&whole, 1}, attributes, options);
}

/// An OpenEXR file of tiles, mip-mapped down to one texel, as renderers read textures: each texel
/// the mean over its area. Wraps east and west, and ends at the poles. A quarter of it is in memory.
///
/// Throws  Error  as write_exr
void write_mipmapped(const std::filesystem::path& path, const Layout& layout, const Rows& rows,
                     const Attributes& attributes, ExrType type = ExrType::half);

/// File format of a display-referred picture, as OpenImageIO calls it: "png", of 8 or 16 bits, or "jpeg", of 8.
struct PictureFormat {
  const char* name = "png";
  int bits = 8;
};

/// Writes a display-referred picture (sRGB-coded, 0 to 1, grey or RGB) whose rows are made meanwhile, as write_exr does,
/// whole or not at all. Numbers of 8 bits are dithered as by write_png.
///
/// Given   attributes  PNG: written as text; JPEG: date and exposure, which become EXIF's
/// Throws  Error       as write_png
void write_picture(const std::filesystem::path& path, const Layout& layout, const Rows& rows,
                   const PictureFormat& format, const Attributes& attributes = {});

/// Writes a display-referred image (sRGB-coded, 0 to 1, grey or RGB) to a PNG file, whole or not at
/// all. Numbers of 8 bits are dithered, so that a slow gradient shows no steps: noise of half a step, the
/// same for each place in each picture; what is a whole number of steps stays as it is.
///
/// Given   bits        8 or 16
///         attributes  written as text
/// Throws  Error       values outside 0 to 1, a number of channels other than 1 or 3, other bits; a
///                     file that cannot be written
void write_png(const std::filesystem::path& path, const Image& image, int bits,
               const Attributes& attributes = {});

/// Writes numbers from 0 to 1 to a TIFF file of 16 bits as they are, not coded for a display; whole or
/// not at all.
///
/// Given   attributes  exposure's standard names become EXIF's
/// Throws  Error       as write_png
void write_tiff(const std::filesystem::path& path, const Image& image,
                const Attributes& attributes = {});

}  // namespace coppermoon::texture
