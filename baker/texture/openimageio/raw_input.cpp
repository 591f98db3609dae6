// SPDX-License-Identifier: MIT
#include "texture/openimageio/raw_input.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "texture/openimageio/image_input.h"

namespace coppermoon::texture {
namespace {

constexpr const char* format = "raw";

/// Matrix, row by row, that converts a camera's channels, white-balanced for D65, to linear Rec. 709. It has four
/// columns, as in LibRaw, because some cameras have four channels.
using Matrix = std::array<float, 12>;

Matrix matrix_of(const glm::dmat3& given) {
  Matrix matrix{};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      matrix[static_cast<std::size_t>(4 * row + column)] = static_cast<float>(given[column][row]);
  return matrix;
}

Matrix matrix_of(const std::filesystem::path& path, const OIIO::ImageSpec& spec) {
  constexpr Matrix unknown{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  Matrix matrix = unknown;
  const auto type = OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, static_cast<int>(matrix.size()));
  if (const auto* found = spec.find_attribute("raw:rgb_cam", type))
    std::copy_n(static_cast<const float*>(found->data()), matrix.size(), matrix.begin());
  if (matrix == unknown)
    throw cannot_read(
        path, fmt::format("no colour matrix is known of the camera {} {}",
                          spec.get_string_attribute("Make"), spec.get_string_attribute("Model")));
  return matrix;
}

/// Marks pixels with a clipped channel. The limit is 0.99, because cameras saturate up to 1 % below nominal white.
std::vector<std::uint8_t> clipped_in(const Image& camera) {
  constexpr float saturated = 0.99F;
  std::vector<std::uint8_t> clipped(camera.width * camera.height);
  for (std::size_t i = 0; i < clipped.size(); ++i) {
    const float* pixel = &camera.values[3 * i];
    clipped[i] = std::max({pixel[0], pixel[1], pixel[2]}) >= saturated;
  }
  return clipped;
}

/// Also marks all eight neighbours of each marked pixel, because linear interpolation reaches that far.
std::vector<std::uint8_t> with_neighbours(const std::vector<std::uint8_t>& clipped,
                                          std::size_t width, std::size_t height) {
  auto all = clipped;
  for (std::size_t r = 0; r < height; ++r)
    for (std::size_t c = 0; c < width; ++c) {
      if (!clipped[r * width + c]) continue;
      for (auto y = r - std::min<std::size_t>(r, 1); y < std::min(r + 2, height); ++y)
        for (auto x = c - std::min<std::size_t>(c, 1); x < std::min(c + 2, width); ++x)
          all[y * width + x] = 1;
    }
  return all;
}

}  // namespace

bool has_raw_ending(const std::filesystem::path& path) {
  const auto ending = path.extension().string();
  if (ending.empty()) return false;
  const auto known = OIIO::get_extension_map();
  const auto raw = known.find(format);
  return raw != known.end() &&
         std::ranges::any_of(raw->second,
                             [given = std::string_view(ending).substr(1)](std::string_view one) {
                               return OIIO::Strutil::iequals(one, given);
                             });
}

bool is_raw(const OIIO::ImageInput& input) {
  return std::string_view(input.format_name()) == format;
}

OIIO::ImageSpec raw_hints() {
  OIIO::ImageSpec hints;
  hints.attribute("raw:ColorSpace", "raw");
  hints.attribute("raw:use_camera_wb", 0);
  hints.attribute("raw:Demosaic", "linear");
  hints.attribute("raw:HighlightMode", 0);
  hints.attribute("raw:auto_bright", 0);
  hints.attribute("raw:adjust_maximum_thr", 0.F);
  return hints;
}

void make_rec709(const std::filesystem::path& path, const OIIO::ImageSpec& spec,
                 const std::optional<glm::dmat3>& given, Image& camera) {
  const auto matrix = given ? matrix_of(*given) : matrix_of(path, spec);
  const auto clipped = with_neighbours(clipped_in(camera), camera.width, camera.height);
  for (std::size_t i = 0; i < clipped.size(); ++i) {
    float* pixel = &camera.values[3 * i];
    const std::array<float, 3> seen{pixel[0], pixel[1], pixel[2]};
    for (std::size_t k = 0; k < 3; ++k) {
      const float* row = &matrix[4 * k];
      const float light = row[0] * seen[0] + row[1] * seen[1] + row[2] * seen[2];
      pixel[k] = clipped[i] ? 1.F : std::min(light, 1.F);
    }
  }
}

}  // namespace coppermoon::texture
