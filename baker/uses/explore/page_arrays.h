// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace coppermoon::uses {

/// Arrays of numbers for a script in a page: little-endian, one behind another, compressed together.
class PageArrays {
 public:
  using Shape = std::vector<std::size_t>;  ///< the last index runs fastest

  /// Throws  Error  when a number is not finite, or there are more or fewer than the shape says
  void add(const std::string& name, const Shape& shape, const std::vector<double>& numbers);

  /// Bytes, each kept as its difference from the one before it in its row, which takes less space.
  ///
  /// Throws  Error  when there are more or fewer than the shape says
  void add(const std::string& name, const Shape& shape, const std::vector<std::uint8_t>& bytes);

  /// A text in UTF-8.
  void add(const std::string& name, std::string_view text);

  /// All arrays of another, behind these.
  void append(const PageArrays& others);

  /// Where each array stands: {name: {"kind": "f32", "u8" or "text", "shape": […], "at": byte}}.
  const nlohmann::ordered_json& index() const { return index_; }

  /// All of them in zlib's format (RFC 1950), as base64.
  ///
  /// Throws  Error  when there is not enough memory
  std::string text() const;

 private:
  void begin(const std::string& name, const char* kind, const Shape& shape, std::size_t count);

  nlohmann::ordered_json index_ = nlohmann::ordered_json::object();
  std::vector<std::uint8_t> bytes_;
};

}  // namespace coppermoon::uses
