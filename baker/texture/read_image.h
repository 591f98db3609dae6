// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <glm/mat3x3.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "algebra/grid.h"
#include "texture/image.h"

namespace coppermoon::texture {

/// Limits of the images that are read, so that no header's claim takes memory or time that its file
/// is not worth: 4 bytes for each number. 65536 x 32768 texels of four channels are within, and a
/// uniform image as DWA packs it, the densest of all: 7000 numbers a byte.
inline constexpr double most_texels_a_side = 1 << 20, most_numbers = 8589934592.,
                        most_numbers_of_any_file = 1 << 24, most_numbers_a_byte = 8192;

/// Every texel of an image file of any kind: floating-point formats as they are, integer formats 0
/// to 1, still coded and turned as in the file; of a camera's raw file its own three channels, linear. EXR,
/// TIFF, PNG, JPEG, FITS, GIF, BMP, PSD, HDR, JPEG 2000, HEIF and WebP are known by their first bytes, others,
/// and raw files, by their names' endings. Of an EXR file the display window, black where its data window
/// does not reach; this and the next two functions.
///
/// Throws  Error  one line with the path: no such file, not permitted, a directory, empty, no
///                image, an image that ends early; a side of more than most_texels_a_side, more
///                numbers (texels by channels) than most_numbers, or more than
///                most_numbers_of_any_file and most_numbers_a_byte for each byte of the file, in all
///                or in a tile
Image read_image(const std::filesystem::path& path);

/// Reads channels of an image of light, which holds floating-point numbers: those named, in that order; or, where it has
/// none of them, those of its only layer that has all, as "ViewLayer.Combined.R".
///
/// Throws  Error  as read_image; when it holds whole numbers, which are codes; when there is no channel of a
///                name: names those there are
Image read_channels(const std::filesystem::path& path, const std::vector<std::string>& names);

/// Texels of a plane.
struct ImageWindow {
  int left = 0, top = 0;
  std::size_t width = 0, height = 0;
  bool operator==(const ImageWindow&) const = default;
};

/// Data window, where an image's texels are, and display window, where its picture is.
struct Windows {
  ImageWindow data, display;
  bool operator==(const Windows&) const = default;
};

/// OpenEXR's data and display window; one of both for other kinds of files.
///
/// Throws  Error  as read_image
Windows windows_of(const std::filesystem::path& path);

/// Attributes of an image file's header, as text, in the order of the names; none where there is none of a name.
///
/// Given   names  as in Attributes
/// Throws  Error  as read_image
std::vector<std::optional<std::string>> read_attributes(const std::filesystem::path& path,
                                                        std::span<const std::string_view> names);

/// One attribute, as read_attributes.
inline std::optional<std::string> read_attribute(const std::filesystem::path& path,
                                                 std::string_view name) {
  return read_attributes(path, {&name, 1}).front();
}

/// Coding of an integer format's numbers. Not every file states it: a TIFF never does.
enum class Coding {
  as_file_says,  ///< and where it says nothing: integers are sRGB, floating point is linear
  srgb,
  linear,
  camera,  ///< by its camera's own tone curve (colour/tone_curve.h): read as sRGB, for what it displays
};

/// Light of an image of any kind: channels R, G, B, all the same for grey, upright. Of an EXR file they
/// are taken by name, R, G and B, or Y alone.
///
/// Colour profiles, primaries, orientation, and whether white is zero are heeded; colours only where the
/// coding is as the file says, or the camera's.
///
/// Of a camera's raw file (CR2, NEF, ARW, DNG, …, whatever LibRaw reads) it is linear Rec. 709 by the
/// camera's colour matrix for D65, upright: white under D65 is neutral, whatever white balance the camera
/// was set to. 1 is where the most sensitive channel saturates. A pixel with a clipped channel, and its
/// neighbours, are 1 in all three; no other number is above 1. Pixels are interpolated linearly.
///
/// Given     rec709_from_raw  matrix for a raw file's channels, balanced for D65; without: the camera's, as LibRaw knows it
/// Returned  linear; integer formats 0 to 1; a raw file's colours outside the gamut below 0
/// Omits     alpha: what is transparent is black; of raw files noise below black, which LibRaw cuts off, lens
///           corrections, sensors without colours
/// Throws    Error  as read_image; when the header says something of the numbers that cannot be heeded:
///                  names it; when channels have other names, as of luminance and chroma, or nothing says
///                  which of them are colours; when one is not finite; when no colour matrix of a raw
///                  file's camera is known, or it is to be coded as sRGB
/// Source    IEC 61966-2-1
Image read_light(const std::filesystem::path& path, Coding coding = Coding::as_file_says,
                 const std::optional<glm::dmat3>& rec709_from_raw = {});

/// Whether a file is a camera's raw file.
///
/// Throws  Error  as read_image
bool is_raw_file(const std::filesystem::path& path);

/// An albedo map: the luminance of an image, row 0 in the north.
///
///     Y = 0.2126 R + 0.7152 G + 0.0722 B        of linear R, G, B; Y alone stands for itself
///
/// Given     path      of any image 2:1, longitude 0 in the middle, east to the right
/// Returned  Y, linear, in the image's own scale; normalise it before use
/// Throws    Error     as read_light; when it is a raw file, not 2:1 or a part of a larger one, a texel is
///                     negative, infinite or no number, transparent, or without data as GDAL marks it; when the
///                     part of the light that the brightest 0.1 % of texels have beyond the 99.9th percentile is
///                     above 1 %
/// Source    ITU-R BT.709, IEC 61966-2-1
algebra::Grid<float> read_albedo_map(const std::filesystem::path& path,
                                     Coding coding = Coding::as_file_says);

/// Refuses a map before it is read, as far as its header tells.
///
/// Throws  Error  as read_albedo_map
void require_albedo_map(const std::filesystem::path& path);

}  // namespace coppermoon::texture
