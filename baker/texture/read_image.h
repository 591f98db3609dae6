// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <glm/mat3x3.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "algebra/grid.h"
#include "texture/image.h"

namespace coppermoon::texture {

/// Limits on the images that are read, so that a false header cannot cost memory or time out of proportion to the file.
/// Each value takes 4 bytes. An image of 65536 x 32768 texels with four channels is within the limits. So is a uniform
/// image compressed with DWA, the densest format of all, which stores 7000 values per byte.
inline constexpr double most_texels_a_side = 1 << 20, most_numbers = 8589934592.,
                        most_numbers_of_any_file = 1 << 24, most_numbers_a_byte = 8192;

/// Reads every texel of an image file of any kind. Floating-point values are unchanged; integers become 0 to 1. Values
/// stay coded and oriented as in the file. A camera's raw file is read as the camera's own three channels, linear. EXR,
/// TIFF, PNG, JPEG, FITS, GIF, BMP, PSD, HDR, JPEG 2000, HEIF and WebP are recognised by their first bytes; other
/// formats, and raw files, by the file's extension. Of an EXR file, the display window is read, which is black outside
/// the data window. The same is true for read_channels and read_light.
///
/// Throws  Error  one line with the path, when the file does not exist, is not readable, is a directory, is empty, is
///                not an image, or ends early; when a side is above most_texels_a_side; when the image or a tile has
///                more values (texels times channels) than most_numbers, or than most_numbers_of_any_file plus
///                most_numbers_a_byte for each byte of the file
Image read_image(const std::filesystem::path& path);

/// Reads the named channels, in the given order, from a scene-linear image, which must hold floating-point numbers. If
/// the image has no channels of these names, they are read from the only layer that has all of them, such as
/// "ViewLayer.Combined.R".
///
/// Throws  Error  as for read_image; when the image holds integers, which are coded; when a named channel is missing
///                (the message lists those that exist)
Image read_channels(const std::filesystem::path& path, const std::vector<std::string>& names);

/// Position and size of a rectangle of texels.
struct ImageWindow {
  int left = 0, top = 0;
  std::size_t width = 0, height = 0;
  bool operator==(const ImageWindow&) const = default;
};

/// Data window (the area for which a file has texels) and display window (the area of the picture).
struct Windows {
  ImageWindow data, display;
  bool operator==(const Windows&) const = default;
};

/// Data window and display window of an OpenEXR file. In other formats, both are the whole image.
///
/// Throws  Error  as for read_image
Windows windows_of(const std::filesystem::path& path);

/// Reads attributes from an image file's header as text, in the order of `names`. A missing attribute gives nullopt.
///
/// Given   names  as in Attributes
/// Throws  Error  as for read_image
std::vector<std::optional<std::string>> read_attributes(const std::filesystem::path& path,
                                                        std::span<const std::string_view> names);

/// Reads one attribute, as read_attributes does.
inline std::optional<std::string> read_attribute(const std::filesystem::path& path,
                                                 std::string_view name) {
  return read_attributes(path, {&name, 1}).front();
}

/// What the numbers of an image mean. Not every file states it: a TIFF never does.
enum class Coding {
  as_file_says,  ///< if the file does not say, integers are sRGB and floating point is linear
  srgb,
  linear,
  camera,  ///< coded with the camera's own tone curve (see colour/tone_curve.h), but read as sRGB
};

/// Names of the encodings of pixel values, on the command line and in Python.
inline constexpr std::array<std::pair<const char*, Coding>, 4> coding_words{
    {{"as-file-says", Coding::as_file_says},
     {"srgb", Coding::srgb},
     {"linear", Coding::linear},
     {"camera", Coding::camera}}};

/// Reads an image of any kind as linear light, turned upright. The channels are R, G and B, all the same for grey. In
/// an EXR file they are found by their names: R, G and B, or Y alone.
///
/// Honours colour profiles, primaries, orientation, and a header that says that 0 is white. Profiles and primaries are
/// used only if the coding is as_file_says or camera.
///
/// A camera's raw file (CR2, NEF, ARW, DNG, or anything else that LibRaw reads) is converted to linear Rec. 709 with
/// the camera's colour matrix for D65. White under D65 is neutral, whatever the camera's white balance was. The value 1
/// is the saturation of the most sensitive channel. A pixel with a clipped channel becomes 1 in all three channels, and
/// so do its neighbours; no other value is above 1. Pixels are interpolated linearly.
///
/// Given     rec709_from_raw  turns raw channels, balanced for D65, into Rec. 709; if absent, LibRaw's matrix is used
/// Returned  linear light; 0 to 1 for integer formats; below 0 for a raw file's colours outside the gamut
/// Omits     alpha, so transparent areas are black; for raw files, noise below black (which LibRaw cuts off), lens
///           corrections, and monochrome sensors
/// Throws    Error  as for read_image; when the header says something about the values that cannot be honoured (the
///                  message names it); when channels have other names, such as those of luminance and chroma, or it is
///                  unknown which of them are colours; when a value is not finite; when the colour matrix of a raw
///                  file's camera is unknown, or a raw file is to be decoded as sRGB
/// Source    IEC 61966-2-1
Image read_light(const std::filesystem::path& path, Coding coding = Coding::as_file_says,
                 const std::optional<glm::dmat3>& rec709_from_raw = {});

/// Whether a file is a camera's raw file.
///
/// Throws  Error  as for read_image
bool is_raw_file(const std::filesystem::path& path);

/// Reads an albedo map: the luminance of an image whose row 0 is in the north.
///
///     Y = 0.2126 R + 0.7152 G + 0.0722 B        for linear R, G, B; a single Y is used unchanged
///
/// Given     path      path of a 2:1 image of any kind, longitude 0 in the middle, east to the right
/// Returned  Y, linear, on the image's own scale; normalise it before use
/// Throws    Error     as for read_light; when the image is a raw file, not 2:1 or cropped from a larger one; when a
///                     texel is negative, infinite, not a number, transparent, or marked by GDAL as missing; when the
///                     brightest 0.1 % of texels exceed the 99.9th percentile by more than 1 % of all light
/// Source    ITU-R BT.709, IEC 61966-2-1
algebra::Grid<float> read_albedo_map(const std::filesystem::path& path,
                                     Coding coding = Coding::as_file_says);

/// Refuses a map that its header shows to be unusable, before the map itself is read.
///
/// Throws  Error  as for read_albedo_map
void require_albedo_map(const std::filesystem::path& path);

}  // namespace coppermoon::texture
