// SPDX-License-Identifier: MIT
#pragma once

#include <OpenImageIO/imagebuf.h>

#include <filesystem>
#include <glm/vec2.hpp>
#include <stdexcept>
#include <vector>

#include "povray_scenes/meridian.h"

namespace coppermoon::povray_scenes {

inline constexpr int columns = 1440, rows = 720;
struct Texel {
  int column, row;
};

inline almanac::SelenographicPoint centre(Texel texel) {
  return place(90 - (texel.row + 0.5) * 180 / rows, (texel.column + 0.5) * 360 / columns - 180);
}

/// A black texture with these texels bright.
inline OIIO::ImageBuf texture_with(const std::vector<Texel>& bright, float luminance = 1000) {
  OIIO::ImageBuf texture(OIIO::ImageSpec(columns, rows, 3, OIIO::TypeHalf));
  const float light[] = {luminance, luminance, luminance};
  for (const auto& texel : bright) texture.setpixel(texel.column, texel.row, light);
  return texture;
}

inline OIIO::ImageBuf uniform_texture(float luminance) {
  OIIO::ImageBuf texture(OIIO::ImageSpec(64, 32, 3, OIIO::TypeHalf));
  const float light[] = {luminance, luminance, luminance};
  for (int row = 0; row < 32; ++row)
    for (int column = 0; column < 64; ++column) texture.setpixel(column, row, light);
  return texture;
}

struct Luminance {
  OIIO::ImageBuf image;

  explicit Luminance(const std::filesystem::path& file) : image(file.string()) {
    if (!image.read(0, 0, true, OIIO::TypeFloat)) throw std::runtime_error(image.geterror());
  }
  double at(int x, int y) const { return image.getchannel(x, y, 0, 1); }
  double total() const {
    double sum = 0;
    for (int y = 0; y < image.spec().height; ++y)
      for (int x = 0; x < image.spec().width; ++x) sum += at(x, y);
    return sum;
  }
};

struct Spot {
  double luminance = 0;
  glm::dvec2 centroid{0, 0};
};

inline Spot spot_near(const Luminance& frame, const glm::dvec2& place, int reach = 5) {
  Spot spot;
  const int x0 = static_cast<int>(place.x), y0 = static_cast<int>(place.y);
  for (int y = y0 - reach; y <= y0 + reach; ++y)
    for (int x = x0 - reach; x <= x0 + reach; ++x) {
      spot.luminance += frame.at(x, y);
      spot.centroid += frame.at(x, y) * glm::dvec2(x + 0.5, y + 0.5);
    }
  if (spot.luminance > 0) spot.centroid /= spot.luminance;
  return spot;
}

}  // namespace coppermoon::povray_scenes
