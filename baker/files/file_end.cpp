// SPDX-License-Identifier: MIT
#include "files/file_end.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

namespace coppermoon::files {
namespace {

using namespace std::string_view_literals;

/// Bytes of a file from a place on; fewer where it ends before.
std::string bytes_at(int descriptor, std::uint64_t place, std::size_t count) {
  std::string bytes(count, '\0');
  const auto got = ::pread(descriptor, bytes.data(), count, static_cast<off_t>(place));
  bytes.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
  return bytes;
}

std::uint64_t big_endian(std::string_view bytes) {
  std::uint64_t number = 0;
  for (const char byte : bytes) number = number << 8U | static_cast<unsigned char>(byte);
  return number;
}

/// Whether the boxes of an ISO base media file fill it. A length of 1 stands for one of 64 bits behind the name, 0 for
/// the rest of the file.
bool boxes_fill(int descriptor, std::uint64_t size) {
  std::uint64_t place = 0;
  while (place < size) {
    const auto head = bytes_at(descriptor, place, 16);
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

bool has_its_end(int descriptor) {
  struct stat about {};
  constexpr int shortest = 8;  // of any kind
  if (::fstat(descriptor, &about) != 0 || about.st_size < shortest) return false;
  const auto size = static_cast<std::uint64_t>(about.st_size);
  constexpr std::uint64_t tail = 64;
  const auto begin = bytes_at(descriptor, 0, 256);
  const auto end = bytes_at(descriptor, size - std::min(size, tail), tail);
  if (begin.starts_with("\x89PNG\r\n\x1a\n"sv)) return end.ends_with("IEND\xae\x42\x60\x82"sv);
  if (begin.starts_with("%PDF-")) return end.find("%%EOF") != end.npos;
  if (begin.starts_with("<?xml") || begin.starts_with("<svg"))
    return end.find("</svg>") != end.npos;
  if (begin.substr(4, 4) == "ftyp") return boxes_fill(descriptor, size);
  return true;
}

}  // namespace coppermoon::files
