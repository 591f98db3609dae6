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

/// Arrays for a script in a page: little-endian, one behind another, compressed together.
class PageArrays {
 public:
  using Shape = std::vector<std::size_t>;  ///< the last index runs fastest

  /// Adds numbers as floats of 32 bits.
  ///
  /// Throws  Error  when a number is not finite, or their count is not the shape's
  void add(const std::string& name, const Shape& shape, std::span<const double> numbers);
  void add(const std::string& name, const algebra::Grid<double>& numbers) {
    add(name, {numbers.rows(), numbers.columns()}, numbers.values());
  }

  /// Adds bytes, each as its difference from the byte before it in its row, which compresses better.
  ///
  /// Throws  Error  when their count is not the shape's
  void add(const std::string& name, const Shape& shape, const std::vector<std::uint8_t>& bytes);

  /// Adds a text in UTF-8.
  void add(const std::string& name, std::string_view text);

  /// Adds all arrays of another.
  void append(const PageArrays& others);

  /// Places of the arrays: {name: {"kind": "f32", "u8" or "text", "shape": […], "at": byte}}.
  const nlohmann::ordered_json& index() const { return index_; }

  /// All arrays in zlib's format (RFC 1950), as base64.
  ///
  /// Throws  Error  when there is too little memory
  std::string text() const;

 private:
  void begin(const std::string& name, const char* kind, const Shape& shape, std::size_t count);

  nlohmann::ordered_json index_ = nlohmann::ordered_json::object();
  std::vector<std::uint8_t> bytes_;
};

}  // namespace coppermoon::uses
