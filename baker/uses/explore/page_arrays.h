// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "algebra/grid.h"

namespace coppermoon::uses {

/// Arrays of little-endian data for the page's script, which are stored one after another and compressed together.
class PageArrays {
 public:
  using Shape = std::vector<std::size_t>;  ///< array dimensions; the last index varies fastest

  /// Adds numbers as 32-bit floats.
  ///
  /// Throws  Error  if a number is not finite, or if the count of numbers does not match the shape
  void add(const std::string& name, const Shape& shape, std::span<const double> numbers);
  void add(const std::string& name, const algebra::Grid<double>& numbers) {
    add(name, {numbers.rows(), numbers.columns()}, numbers.values());
  }

  /// Adds bytes. Each is stored as its difference from the previous byte in the row, because this compresses better.
  ///
  /// Throws  Error  if the count of bytes does not match the shape
  void add(const std::string& name, const Shape& shape, const std::vector<std::uint8_t>& bytes);

  /// Adds UTF-8 text as an array of bytes.
  void add(const std::string& name, std::string_view text);

  void append(const PageArrays& others);

  /// Positions of the arrays in the data: {name: {"kind": "f32", "u8" or "text", "shape": […], "at": byte}}.
  const nlohmann::ordered_json& index() const { return index_; }

  /// All arrays, compressed in zlib's format (RFC 1950) and encoded as base64.
  ///
  /// Throws  Error  if memory runs out
  std::string text() const;

 private:
  void begin(const std::string& name, const char* kind, const Shape& shape, std::size_t count);

  nlohmann::ordered_json index_ = nlohmann::ordered_json::object();
  std::vector<std::uint8_t> bytes_;
};

}  // namespace coppermoon::uses
