// SPDX-License-Identifier: MIT
#include "texture/seal.h"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>

#include "algebra/error.h"
#include "files/fingerprint.h"

namespace coppermoon::texture {
namespace {

using namespace std::string_view_literals;

constexpr std::size_t seal_digits = 16;
constexpr std::size_t at_once = 4 << 20;  // bytes read at once; the first block contains the header

/// Offset of the fingerprint's digits in a file. OpenEXR writes them after the attribute's name, type and length.
std::optional<std::size_t> place_of_digits(const files::Handle& file) {
  const auto before = std::string(seal_attribute) + std::string("\0string\0\x10\0\0\0"sv);
  const auto bytes = files::bytes_at(file, 0, at_once);
  const auto found = bytes.find(before);
  if (found == bytes.npos || bytes.size() - found < before.size() + seal_digits)
    return std::nullopt;
  return found + before.size();
}

/// Fingerprint of a file, computed as if the placeholder `unsealed` were still in its header.
std::string digits_of(const files::Handle& file, std::size_t place) {
  std::uint64_t at = 0;
  return fmt::format("{:016x}", files::fingerprint_of_pieces([&] {
                       auto bytes = files::bytes_at(file, at, at_once);
                       if (at == 0 && !bytes.empty()) bytes.replace(place, seal_digits, unsealed);
                       at += bytes.size();
                       return bytes;
                     }));
}

}  // namespace

void seal(const files::Handle& file, const std::filesystem::path& path) {
  const auto place = place_of_digits(file);
  if (!place)
    throw algebra::Error(fmt::format("{}: has no attribute {}", path.string(), seal_attribute));
  if (const auto reason = files::write_at(file, *place, digits_of(file, *place)))
    throw algebra::Error(fmt::format("{}: cannot be written: {}", path.string(), reason.message()));
}

bool is_sealed(const std::filesystem::path& path) {
  const auto file = files::opened(path);
  if (files::size_of(file) == 0) return false;
  const auto place = place_of_digits(file);
  return place && files::bytes_at(file, *place, seal_digits) == digits_of(file, *place);
}

}  // namespace coppermoon::texture
