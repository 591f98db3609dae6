// SPDX-License-Identifier: MIT
#include "uses/picture/picture_files.h"

#include <array>

#include "uses/picture/avif_file.h"
#include "uses/picture/pixels.h"

namespace coppermoon::uses {
namespace {

namespace fs = std::filesystem;

void write_as_png(const fs::path& file, const ShownPicture& picture) {
  texture::write_picture(file, picture.layout, picture.rows, {"png", picture.bits},
                         picture.attributes);
}

void write_as_jpeg(const fs::path& file, const ShownPicture& picture) {
  texture::write_picture(file, picture.layout, picture.rows, {"jpeg", 8}, picture.attributes);
}

void write_as_avif(const fs::path& file, const ShownPicture& picture) {
  write_avif(file, image_of(picture.layout, picture.rows));
}

constexpr std::array files_of_pictures{
    PictureFile{{".png", ""}, false, write_as_png},
    PictureFile{{".jpg", "8 bits, without its recipe"}, false, write_as_jpeg},
    PictureFile{{".avif", "high dynamic range"}, true, write_as_avif}};

}  // namespace

std::span<const PictureFile> picture_files() { return files_of_pictures; }

}  // namespace coppermoon::uses
