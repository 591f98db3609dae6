// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace coppermoon::texture {

/// Texels with any number of named channels, stored row by row from the top. A texel's channels are stored together.
struct Image {
  std::size_t width = 0, height = 0;
  std::vector<std::string> channels;
  std::vector<float> values;  ///< [row][column][channel]

  Image() = default;
  /// An image of zeros.
  Image(std::size_t columns, std::size_t rows, std::vector<std::string> names)
      : width(columns),
        height(rows),
        channels(std::move(names)),
        values(columns * rows * channels.size()) {}

  float& operator()(std::size_t row, std::size_t column, std::size_t channel) {
    return values[index(row, column, channel)];
  }
  float operator()(std::size_t row, std::size_t column, std::size_t channel) const {
    return values[index(row, column, channel)];
  }

 private:
  std::size_t index(std::size_t row, std::size_t column, std::size_t channel) const {
    assert(row < height && column < width && channel < channels.size());
    return (row * width + column) * channels.size() + channel;
  }
};

/// An image's size and channels, without its values.
struct Layout {
  std::size_t width = 0, height = 0;
  std::vector<std::string> channels;
};

/// Makes an image on demand. The function fills `values` with whole rows, [row][column][channel], from `first_row` on.
using Rows = std::function<void(std::size_t first_row, std::span<float> values)>;

/// Rows of an existing image, which must outlive the returned function.
inline Rows rows_of(const Image& image) {
  return [&image](std::size_t first_row, std::span<float> values) {
    const std::size_t length = image.width * image.channels.size();
    std::copy_n(&image.values[first_row * length], values.size(), values.begin());
  };
}

/// A value in an image file's header.
using Attribute = std::variant<std::string, float, int, std::vector<float>>;

/// Values in a file's header, by name. OpenEXR's standard names have OpenEXR's meaning: `capDate`, `utcOffset`
/// [s], `longitude`, `latitude` [degrees], `altitude` [m], `expTime` [s], `aperture`, `isoSpeed`, `whiteLuminance`
/// [cd/m²], `chromaticities` (8 numbers), `colorInteropID`, `framesPerSecond` (2 numbers, such as 24000 and 1001),
/// `owner`, `comments`.
using Attributes = std::map<std::string, Attribute, std::less<>>;

}  // namespace coppermoon::texture
