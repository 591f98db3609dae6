// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "texture/image.h"

namespace coppermoon::texture {

/// A picture of a contact sheet, and what stands under its left and its right end.
struct SheetPicture {
  std::filesystem::path file;  ///< sRGB-coded, three channels
  std::string left, right;
  bool marked = false;  ///< what stands under it is bright, else dim
};

/// Pictures side by side, row by row, under a title.
struct ContactSheet {
  std::string title;
  std::vector<SheetPicture> pictures;
  std::size_t columns = 1;
  std::filesystem::path font;  ///< a TrueType file
};

/// Where things stand on it [pixels].
struct SheetGrid {
  static constexpr std::size_t picture_width = 240, gap = 24, title_height = 60,
                               title_baseline = 38, label_height = 20, baseline = 18;
  std::size_t columns, rows, picture_height;

  std::size_t width() const { return gap + columns * (picture_width + gap); }
  std::size_t height() const { return title_height + rows * row_height(); }
  std::size_t row_height() const { return picture_height + label_height + gap; }
  /// Pixels from the sheet's left edge and top to a picture's upper left corner.
  std::size_t left(std::size_t index) const {
    return gap + index % columns * (picture_width + gap);
  }
  std::size_t top(std::size_t index) const { return title_height + index / columns * row_height(); }
};

/// Given  width, height  of each picture
SheetGrid sheet_grid(std::size_t pictures, std::size_t columns, std::size_t width,
                     std::size_t height);

/// A font of the system's for it.
///
/// Throws  Error  when there is none where systems keep them: names a package
std::filesystem::path sheet_font();

/// Draws it on black, one picture in memory at a time. Pictures get the width of SheetGrid, light
/// averaged, all in the shape of the first; a title that is too long for the sheet is smaller.
///
/// Returned  sRGB-coded, 0 to 1: R, G, B
/// Throws    Error  as read_image; when there is no picture, a picture has not three channels, or
///                  the font is none
Image drawn(const ContactSheet& sheet);

}  // namespace coppermoon::texture
