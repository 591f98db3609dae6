// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <span>

#include "files/endings.h"
#include "texture/image.h"
#include "texture/write_image.h"

namespace coppermoon::uses {

/// A display-referred picture whose rows are computed as they are written: channels R, G, B, 0 to 1.
struct ShownPicture {
  texture::Layout layout;
  texture::Rows rows;
  int bits = 8;  ///< bits per number, if the format allows a choice
  texture::Attributes attributes = {};
};

/// Format of a developed picture.
struct PictureFile : files::Ending {
  bool high_range;  ///< whether it is for screens of high dynamic range
  void (*write)(const std::filesystem::path& file, const ShownPicture& picture);
};

std::span<const PictureFile> picture_files();

/// Writes a picture of high dynamic range as .avif with 12 bits, Rec.2020 primaries and PQ (SMPTE ST 2084). Its code
/// points in ITU-T H.273 are 9/16/9. The file appears whole or not at all.
///
/// Given     picture     channels R, G, B, already coded as PQ, 0 to 1
/// Accuracy  the encoder changes light by less than 2 % in 95 % of pixels
/// Throws    Error       when avifenc is missing or fails, or the file cannot be written
void write_avif(const std::filesystem::path& file, const texture::Image& picture);

/// Decodes and encodes PQ, with codes from 0 to 1, and light in units of 10 000 cd/m².
///
/// Source  SMPTE ST 2084:2014
double light_of_pq(double code);
double pq_of_light(double light);

}  // namespace coppermoon::uses
