// SPDX-License-Identifier: MIT
#pragma once

#include <zlib.h>

#include <cstring>
#include <string>
#include <vector>

#include "uses/explore/page_arrays.h"

namespace coppermoon::uses {

/// The bytes of some arrays as a page gets them: base64 and zlib's format undone by zlib, not by us.
inline std::vector<unsigned char> bytes_in_page(const PageArrays& arrays) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<unsigned char> packed;
  unsigned bits = 0, count = 0;
  for (const char letter : arrays.text()) {
    if (letter == '=') break;
    bits = bits << 6 | static_cast<unsigned>(letters.find(letter));
    if ((count += 6) >= 8) packed.push_back(static_cast<unsigned char>(bits >> (count -= 8)));
  }
  std::vector<unsigned char> bytes(std::size_t{1} << 24);
  uLongf size = bytes.size();
  if (uncompress(bytes.data(), &size, packed.data(), packed.size()) != Z_OK) size = 0;
  bytes.resize(size);
  return bytes;
}

/// An array of single precision.
inline std::vector<float> numbers_in_page(const PageArrays& arrays, const std::string& name) {
  const auto bytes = bytes_in_page(arrays);
  const auto& array = arrays.index()[name];
  std::size_t count = 1;
  for (const auto& side : array["shape"]) count *= side.get<std::size_t>();
  std::vector<float> numbers(count);
  std::memcpy(numbers.data(), bytes.data() + array["at"].get<std::size_t>(), 4 * count);
  return numbers;
}

}  // namespace coppermoon::uses
