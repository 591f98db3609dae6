// SPDX-License-Identifier: MIT
#include "uses/picture/raw_file.h"

#include <fmt/format.h>

#include "algebra/error.h"
#include "texture/write_dng.h"
#include "texture/write_image.h"
#include "uses/picture/pixels.h"

namespace coppermoon::uses {
namespace {

bool is_dng(const std::filesystem::path& file) { return file.extension() == ".dng"; }

/// One channel of every pixel: red and green in the first row, green and blue in the next.
algebra::Grid<std::uint16_t> mosaic_of(const algebra::Grid<colour::RawPixel>& raw) {
  algebra::Grid<std::uint16_t> mosaic(raw.rows(), raw.columns());
  for (std::size_t r = 0; r < raw.rows(); ++r)
    for (std::size_t c = 0; c < raw.columns(); ++c) mosaic(r, c) = raw(r, c)[r % 2 + c % 2];
  return mosaic;
}

}  // namespace

void require_raw_file(const std::filesystem::path& file, const colour::Camera& camera) {
  if (file.extension() != ".tif" && !is_dng(file))
    throw algebra::Error(fmt::format("{}: a raw file ends in .tif, or in .dng", file.string()));
  if (is_dng(file) && camera.sensor.response == "luminance")
    throw algebra::Error(
        fmt::format("{}: response = luminance, allowed for a raw file that ends in .dng a sensor "
                    "that sees colours",
                    file.string()));
}

void write_raw(const std::filesystem::path& file, const CameraRequest& request,
               const colour::Camera& camera, double iso, const colour::Photograph& photograph,
               const texture::Attributes& attributes) {
  require_raw_file(file, camera);
  if (!is_dng(file)) return texture::write_tiff(file, image_of(photograph.raw), attributes);
  const auto response = colour::response_named(camera.sensor.response);
  auto camera_from_xyz = response.from_xyz;
  for (int column = 0; column < 3; ++column) camera_from_xyz[column] *= response.sensitivity;
  const double black_dn = camera.sensor.black_level_dn;
  texture::write_dng(file,
                     {.numbers = mosaic_of(photograph.raw),
                      .black_dn = black_dn,
                      .white_dn = black_dn + colour::gain_at(camera, iso).white_dn,
                      .camera_from_xyz = camera_from_xyz,
                      .camera = request.model,
                      .focal_length_mm = camera.optics.focal_length_mm},
                     attributes);
}

}  // namespace coppermoon::uses
