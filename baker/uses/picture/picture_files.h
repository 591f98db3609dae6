// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <span>

#include "files/endings.h"
#include "texture/write_image.h"

namespace coppermoon::uses {

/// Display-referred picture whose rows are made as they are written: channels R, G, B, 0 to 1.
struct ShownPicture {
  texture::Layout layout;
  texture::Rows rows;
  int bits = 8;  ///< of a number, where the format leaves the choice
  texture::Attributes attributes = {};
};

/// Format of a developed picture.
struct PictureFile : files::Ending {
  bool high_range;  ///< for screens of high dynamic range
  void (*write)(const std::filesystem::path& file, const ShownPicture& picture);
};

/// All of them.
std::span<const PictureFile> picture_files();

}  // namespace coppermoon::uses
