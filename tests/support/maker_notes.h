// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <exiv2/exiv2.hpp>
#include <string>

namespace coppermoon::support {

/// Writes a white balance into a JPEG's notes of its maker, as Canon or as Nikon does: gains of red, green and blue.
inline void write_balance(const std::string& file, const std::string& make,
                          const std::array<double, 3>& gains) {
  const auto image = Exiv2::ImageFactory::open(file);
  image->readMetadata();
  auto& header = image->exifData();
  header["Exif.Image.Make"] = make;
  if (make == "Canon") {
    constexpr std::size_t numbers = 1338, first = 63;  // EOS 550D and 600D: ColorData4 of ExifTool
    Exiv2::UShortValue data;
    data.value_.assign(numbers, 0);
    constexpr std::array<std::size_t, 4> channels{0, 1, 1, 2};
    for (std::size_t i = 0; i < channels.size(); ++i)
      data.value_[first + i] = static_cast<std::uint16_t>(std::lround(1024 * gains[channels[i]]));
    header.add(Exiv2::ExifKey("Exif.Canon.ColorData"), &data);
  } else {
    Exiv2::URationalValue data;
    for (const double gain : {gains[0] / gains[1], gains[2] / gains[1], 1., 1.})
      data.value_.emplace_back(std::lround(256 * gain), 256);
    header.add(Exiv2::ExifKey("Exif.Nikon3.WB_RBLevels"), &data);
  }
  image->writeMetadata();
}

}  // namespace coppermoon::support
