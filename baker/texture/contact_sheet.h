// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "texture/image.h"

namespace coppermoon::texture {

/// A picture in a contact sheet, with captions under its left and right ends.
struct SheetPicture {
  std::filesystem::path file;  ///< image file with three sRGB-coded channels
  std::string left, right;
  bool marked = false;  ///< whether its captions are bright rather than dim
};

/// Pictures side by side, row by row, under a title.
struct ContactSheet {
  std::string title;
  std::vector<SheetPicture> pictures;
  std::size_t columns = 1;
  std::filesystem::path font;  ///< path of a TrueType file
};

/// Layout of a contact sheet [pixels].
struct SheetGrid {
  static constexpr std::size_t picture_width = 240, gap = 24, title_height = 60,
                               title_baseline = 38, label_height = 20, baseline = 18;
  std::size_t columns, rows, picture_height;

  std::size_t width() const { return gap + columns * (picture_width + gap); }
  std::size_t height() const { return title_height + rows * row_height(); }
  std::size_t row_height() const { return picture_height + label_height + gap; }
  /// Distance from the sheet's left edge to the left edge of a picture; `top` is the same for the top edges.
  std::size_t left(std::size_t index) const {
    return gap + index % columns * (picture_width + gap);
  }
  std::size_t top(std::size_t index) const { return title_height + index / columns * row_height(); }
};

/// Layout of a contact sheet with the given number of pictures.
///
/// Given  width, height  size of the first picture; all pictures get its shape
inline SheetGrid sheet_grid(std::size_t pictures, std::size_t columns, std::size_t width,
                            std::size_t height) {
  const std::size_t across = std::clamp<std::size_t>(pictures, 1, columns);
  return {across, (pictures + across - 1) / across,
          std::max<std::size_t>(1, SheetGrid::picture_width * height / width)};
}

/// Path of a system font for a contact sheet.
///
/// Throws  Error  when no known font is installed; the message names a package to install
std::filesystem::path sheet_font();

/// Draws a contact sheet on a black background, with only one picture in memory at a time. Pictures are scaled to
/// SheetGrid's width by averaging light, and all get the first one's shape. A title that is too long is set smaller.
///
/// Returned  image with the channels R, G and B, sRGB-coded, 0 to 1
/// Throws    Error  as for read_image; when there is no picture, a picture does not have three channels, or the font
///                  cannot be used
Image drawn(const ContactSheet& sheet);

/// Writes captions into the lower left and right corners of a developed picture. The letters' size is 1/36 of the
/// picture's height, but at least 9 pixels. It is reduced if the two captions would meet.
///
/// Given   picture  has three channels
///         grey     level of the letters, coded like the picture
///         font     path of a TrueType file
/// Throws  Error    when the font cannot be used
void write_captions(Image& picture, const std::string& left, const std::string& right, float grey,
                    const std::filesystem::path& font);

}  // namespace coppermoon::texture
