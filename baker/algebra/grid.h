// SPDX-License-Identifier: MIT
#pragma once

#include <cassert>
#include <cstddef>
#include <span>
#include <vector>

namespace coppermoon::algebra {

/// Values over two indices, row by row. The one place where index arithmetic is written.
template <class T>
class Grid {
 public:
  Grid() = default;
  Grid(std::size_t rows, std::size_t columns, T value = {})
      : rows_(rows), columns_(columns), values_(rows * columns, value) {}

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_; }
  bool empty() const { return values_.empty(); }

  T& operator()(std::size_t row, std::size_t column) { return values_[index(row, column)]; }
  const T& operator()(std::size_t row, std::size_t column) const {
    return values_[index(row, column)];
  }
  std::span<T> row(std::size_t r) { return {&values_[index(r, 0)], columns_}; }
  std::span<const T> row(std::size_t r) const { return {&values_[index(r, 0)], columns_}; }
  std::span<T> values() { return values_; }
  std::span<const T> values() const { return values_; }

 private:
  std::size_t index(std::size_t row, std::size_t column) const {
    assert(row < rows_ && column < columns_);
    return row * columns_ + column;
  }
  std::size_t rows_ = 0, columns_ = 0;
  std::vector<T> values_;
};

}  // namespace coppermoon::algebra
