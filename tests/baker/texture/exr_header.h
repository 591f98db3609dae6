// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstring>
#include <map>
#include <string>

/// One attribute as it lies in the file.
struct ExrAttribute {
  std::string type, bytes;

  /// The n-th number of four bytes.
  template <class Number>
  Number at(std::size_t n) const {
    Number number;
    std::memcpy(&number, bytes.data() + n * sizeof number, sizeof number);
    return number;
  }
};

/// The header of a single-part OpenEXR file, read from its bytes by the format's description: eight
/// bytes, then name, type (each ended by 0), size, value, until an empty name. Knows nothing of the
/// library that wrote it.
inline std::map<std::string, ExrAttribute> exr_header(const std::string& file) {
  std::map<std::string, ExrAttribute> header;
  for (std::size_t at = 8; at < file.size() && file[at] != 0;) {
    const std::string name = file.c_str() + at;
    at += name.size() + 1;
    const std::string type = file.c_str() + at;
    at += type.size() + 1;
    std::uint32_t size = 0;
    std::memcpy(&size, file.data() + at, 4);
    header[name] = {type, file.substr(at + 4, size)};
    at += 4 + size;
  }
  return header;
}
