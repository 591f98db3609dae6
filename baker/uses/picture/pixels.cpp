// SPDX-License-Identifier: MIT
#include "uses/picture/pixels.h"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include "algebra/error.h"

namespace coppermoon::uses {
namespace {

/// Stores the three channels of each pixel one after the other, as an image does.
template <class Pixels>
texture::Image three_channels(const Pixels& pixels, float unit) {
  texture::Image image(pixels.columns(), pixels.rows(), {"R", "G", "B"});
  auto value = image.values.begin();
  for (const auto& pixel : pixels.values())
    for (const auto number : pixel) *value++ = static_cast<float>(number) / unit;
  return image;
}

}  // namespace

float as_half(double value) {
  constexpr double most = 65504;
  constexpr int bits = 11, least_exponent = -13;
  if (!(value < most)) return static_cast<float>(value);
  int exponent = 0;
  std::frexp(value, &exponent);
  const int step = std::max(exponent, least_exponent) - bits;
  return static_cast<float>(std::ldexp(std::nearbyint(std::ldexp(value, -step)), step));
}

void require_colours(const texture::Image& image) {
  if (image.channels.size() < 3)
    throw algebra::Error(
        fmt::format("the frame has {} channels, allowed 3 or more", image.channels.size()));
}

colour::Image pixels_of(const texture::Image& image) {
  require_colours(image);
  colour::Image pixels(image.height, image.width);
  for (std::size_t r = 0; r < image.height; ++r)
    for (std::size_t c = 0; c < image.width; ++c)
      pixels(r, c) = {image(r, c, 0), image(r, c, 1), image(r, c, 2)};
  return pixels;
}

texture::Image in_space(const texture::Image& image, colour::WorkingSpace from,
                        colour::WorkingSpace to) {
  const auto change = colour::channels_from_xyz(to) * glm::inverse(colour::channels_from_xyz(from));
  auto pixels = pixels_of(image);
  if (from != to)
    for (auto& pixel : pixels.values()) {
      const auto colour = change * glm::dvec3(pixel[0], pixel[1], pixel[2]);
      for (int c = 0; c < 3; ++c)
        pixel[static_cast<std::size_t>(c)] = static_cast<float>(colour[c]);
    }
  auto changed = image_of(pixels);
  if (to == colour::WorkingSpace::ciexyz_d65) changed.channels = {"X", "Y", "Z"};
  return changed;
}

algebra::Grid<float> channel_of(const texture::Image& image, std::size_t channel) {
  algebra::Grid<float> values(image.height, image.width);
  for (std::size_t i = 0; i < values.values().size(); ++i)
    values.values()[i] = image.values[i * image.channels.size() + channel];
  return values;
}

texture::Image image_of(const texture::Layout& layout, const texture::Rows& rows) {
  constexpr std::size_t rows_at_once = 64;
  texture::Image image(layout.width, layout.height, layout.channels);
  const std::size_t length = layout.width * layout.channels.size();
  for (std::size_t row = 0; row < layout.height; row += rows_at_once)
    rows(row, std::span(image.values)
                  .subspan(row * length, std::min(rows_at_once, layout.height - row) * length));
  return image;
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
