// SPDX-License-Identifier: MIT
#include "uses/explore/page_arrays.h"

#include <fmt/format.h>
#include <zlib.h>

#include <bit>
#include <cmath>
#include <functional>
#include <numeric>

#include "algebra/error.h"

namespace coppermoon::uses {
namespace {

std::string as_base64(const std::vector<std::uint8_t>& bytes) {
  constexpr std::string_view letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8 | (i + k < bytes.size() ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? letters[three >> (18 - 6 * k) & 63U] : '=';
  }
  return text;
}

}  // namespace

void PageArrays::begin(const std::string& name, const char* kind, const Shape& shape,
                       std::size_t count) {
  const auto wanted =
      std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
  if (wanted != count)
    throw algebra::Error(fmt::format("{}: has {} values, allowed {}", name, count, wanted));
  bytes_.resize((bytes_.size() + 3) / 4 * 4);  // floats must start at a multiple of 4
  index_[name] = {{"kind", kind}, {"shape", shape}, {"at", bytes_.size()}};
}

void PageArrays::add(const std::string& name, const Shape& shape, std::span<const double> numbers) {
  begin(name, "f32", shape, numbers.size());
  for (const double number : numbers) {
    const auto single = static_cast<float>(number);
    if (!std::isfinite(single))
      throw algebra::Error(fmt::format("{}: has {}, allowed finite numbers", name, number));
    const auto bits = std::bit_cast<std::uint32_t>(single);
    for (unsigned shift = 0; shift < 32; shift += 8)
      bytes_.push_back(static_cast<std::uint8_t>(bits >> shift));
  }
}

void PageArrays::add(const std::string& name, const Shape& shape,
                     const std::vector<std::uint8_t>& bytes) {
  begin(name, "u8", shape, bytes.size());
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const std::uint8_t before = i % shape.back() == 0 ? 0 : bytes[i - 1];
    bytes_.push_back(static_cast<std::uint8_t>(bytes[i] - before));
  }
}

void PageArrays::add(const std::string& name, std::string_view text) {
  begin(name, "text", {text.size()}, text.size());
  bytes_.insert(bytes_.end(), text.begin(), text.end());
}

void PageArrays::append(const PageArrays& others) {
  bytes_.resize((bytes_.size() + 3) / 4 * 4);
  for (auto [name, array] : others.index_.items()) {
    index_[name] = array;
    index_[name]["at"] = bytes_.size() + array["at"].get<std::size_t>();
  }
  bytes_.insert(bytes_.end(), others.bytes_.begin(), others.bytes_.end());
}

std::string PageArrays::text() const {
  const auto length = static_cast<uLong>(bytes_.size());
  uLongf size = compressBound(length);
  std::vector<std::uint8_t> compressed(size);
  if (compress2(compressed.data(), &size, bytes_.data(), length, Z_BEST_COMPRESSION) != Z_OK)
    throw algebra::Error("the page's numbers: not enough memory to compress them");
  compressed.resize(size);
  return as_base64(compressed);
}

}  // namespace coppermoon::uses
