// SPDX-License-Identifier: MIT
#include "uses/picture/pixels.h"

#include "algebra/error.h"

namespace coppermoon::uses {
namespace {

/// Three channels in a row, as they are in an image's values.
template <class Pixels>
texture::Image three_channels(const Pixels& pixels, float unit) {
  texture::Image image(pixels.columns(), pixels.rows(), {"R", "G", "B"});
  auto value = image.values.begin();
  for (const auto& pixel : pixels.values())
    for (const auto number : pixel) *value++ = static_cast<float>(number) / unit;
  return image;
}

}  // namespace

colour::Image pixels_of(const texture::Image& image) {
  if (image.channels.size() < 3)
    throw algebra::Error(
        fmt::format("the frame has {} channels, allowed 3 or more", image.channels.size()));
  colour::Image pixels(image.height, image.width);
  for (std::size_t r = 0; r < image.height; ++r)
    for (std::size_t c = 0; c < image.width; ++c)
      pixels(r, c) = {image(r, c, 0), image(r, c, 1), image(r, c, 2)};
  return pixels;
}

algebra::Grid<float> channel_of(const texture::Image& image, std::size_t channel) {
  algebra::Grid<float> values(image.height, image.width);
  for (std::size_t i = 0; i < values.values().size(); ++i)
    values.values()[i] = image.values[i * image.channels.size() + channel];
  return values;
}

texture::Image image_of(const colour::Image& pixels) { return three_channels(pixels, 1); }

texture::Image image_of(const algebra::Grid<colour::RawPixel>& raw) {
  return three_channels(raw, 65535);
}

texture::Image image_of(const colour::Image& pixels, const algebra::Grid<float>& valid) {
  texture::Image image(pixels.columns(), pixels.rows(), {"R", "G", "B", "valid"});
  for (std::size_t r = 0; r < image.height; ++r)
    for (std::size_t c = 0; c < image.width; ++c) {
      for (std::size_t k = 0; k < 3; ++k) image(r, c, k) = pixels(r, c)[k];
      image(r, c, 3) = valid(r, c);
    }
  return image;
}

}  // namespace coppermoon::uses
