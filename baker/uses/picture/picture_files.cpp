// SPDX-License-Identifier: MIT
#include "uses/picture/picture_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <sstream>

#include "files/child_process.h"
#include "files/temporary_folder.h"
#include "files/whole_file.h"
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

constexpr double m1 = 2610. / 16384, m2 = 2523. / 4096 * 128, c1 = 3424. / 4096,
                 c2 = 2413. / 4096 * 32, c3 = 2392. / 4096 * 32;

}  // namespace

std::span<const PictureFile> picture_files() { return files_of_pictures; }

double light_of_pq(double code) {
  const double p = std::pow(std::clamp(code, 0., 1.), 1 / m2);
  return std::pow(std::max(p - c1, 0.) / (c2 - c3 * p), 1 / m1);
}

double pq_of_light(double light) {
  const double p = std::pow(std::clamp(light, 0., 1.), m1);
  return std::pow((c1 + c2 * p) / (1 + c3 * p), m2);
}

void write_avif(const std::filesystem::path& file, const texture::Image& picture) {
  const files::TemporaryFolder folder;
  texture::write_png(folder.path() / "picture.png", picture, 16);
  std::istringstream words(
      "avifenc --cicp 9/16/9 --depth 12 --yuv 444 --range full --min 0 --max 2 --speed 6 --jobs "
      "all "
      "--ignore-exif --ignore-icc picture.png picture.avif");
  files::run_program({.words = {std::istream_iterator<std::string>(words), {}},
                      .package = "libavif-bin",
                      .folder = folder.path()});
  const auto made = folder.path() / "picture.avif";
  files::require_whole(files::opened(made), "avifenc");
  files::write_whole(file, files::bytes_of(made));
}

}  // namespace coppermoon::uses
