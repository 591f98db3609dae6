// SPDX-License-Identifier: MIT
#include "files/file_end.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

namespace coppermoon::files {
namespace {

using namespace std::string_view_literals;

std::uint64_t big_endian(std::string_view bytes) {
  std::uint64_t number = 0;
  for (const char byte : bytes) number = number << 8U | static_cast<unsigned char>(byte);
  return number;
}

/// Whether the last box of an ISO base media file ends exactly where the file ends. A length of 1 means that a 64-bit
/// length follows the box's name; a length of 0 means that the box fills the rest of the file.
bool boxes_fill(const Handle& file, std::uint64_t size) {
  std::uint64_t place = 0;
  while (place < size) {
    const auto head = bytes_at(file, place, 16);
    if (head.size() < 8) return false;
    auto length = big_endian(std::string_view(head).substr(0, 4));
    if (length == 0) return true;
    if (length == 1) length = head.size() < 16 ? 0 : big_endian(std::string_view(head).substr(8));
    if (length < 8 || length > size - place) return false;
    place += length;
  }
  return true;
}

}  // namespace

bool has_its_end(const Handle& file) {
  const auto size = size_of(file);
  constexpr std::uint64_t shortest = 8, tail = 64;  // minimum size, and length of the tail [bytes]
  if (size < shortest) return false;
  const auto begin = bytes_at(file, 0, 256);
  const auto end = bytes_at(file, size - std::min(size, tail), tail);
  if (begin.starts_with("\x89PNG\r\n\x1a\n"sv)) return end.ends_with("IEND\xae\x42\x60\x82"sv);
  if (begin.starts_with("%PDF-")) return end.find("%%EOF") != end.npos;
  if (begin.starts_with("<?xml") || begin.starts_with("<svg"))
    return end.find("</svg>") != end.npos;
  if (begin.substr(4, 4) == "ftyp") return boxes_fill(file, size);
  return true;
}

}  // namespace coppermoon::files
