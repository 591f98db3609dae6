// SPDX-License-Identifier: MIT
#include "uses/picture/avif_file.h"

#include <algorithm>
#include <cmath>

#include "files/child_process.h"
#include "files/temporary_folder.h"
#include "files/whole_file.h"
#include "texture/write_image.h"

namespace coppermoon::uses {
namespace {

constexpr double m1 = 2610. / 16384, m2 = 2523. / 4096 * 128, c1 = 3424. / 4096,
                 c2 = 2413. / 4096 * 32, c3 = 2392. / 4096 * 32;

}  // namespace

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
  files::run_program({.words = {"avifenc",
                                "--cicp",
                                "9/16/9",
                                "--depth",
                                "12",
                                "--yuv",
                                "444",
                                "--range",
                                "full",
                                "--min",
                                "0",
                                "--max",
                                "2",
                                "--speed",
                                "6",
                                "--jobs",
                                "all",
                                "--ignore-exif",
                                "--ignore-icc",
                                "picture.png",
                                "picture.avif"},
                      .package = "libavif-bin",
                      .folder = folder.path()});
  const auto made = folder.path() / "picture.avif";
  files::require_whole(files::opened(made), "avifenc");
  files::write_whole(file, files::bytes_of(made));
}

}  // namespace coppermoon::uses
