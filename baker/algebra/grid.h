// SPDX-License-Identifier: MIT
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace coppermoon::algebra {

/// Allocator that returns zeroed memory. The system provides each page only when it is first written to.
template <class T>
struct ZeroedMemory {
  using value_type = T;

  ZeroedMemory() = default;
  template <class U>
  explicit ZeroedMemory(const ZeroedMemory<U>&) {}

  T* allocate(std::size_t count) {
    if (auto* memory = static_cast<T*>(std::calloc(count, sizeof(T)))) return memory;
    throw std::bad_alloc();
  }
  void deallocate(T* memory, std::size_t) { std::free(memory); }
  /// Does nothing, because the allocated memory is already zero.
  void construct(T*) {}
  template <class... Arguments>
  void construct(T* at, Arguments&&... arguments) {
    std::construct_at(at, std::forward<Arguments>(arguments)...);
  }
  bool operator==(const ZeroedMemory&) const { return true; }
};

/// Two-dimensional array of values, stored row by row.
template <class T>
class Grid {
 public:
  Grid() = default;
  Grid(std::size_t rows, std::size_t columns)
      : rows_(rows), columns_(columns), values_(rows * columns) {}
  Grid(std::size_t rows, std::size_t columns, const T& value)
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
  static constexpr bool numbers = std::is_arithmetic_v<T>;
  std::vector<T, std::conditional_t<numbers, ZeroedMemory<T>, std::allocator<T>>> values_;
};

}  // namespace coppermoon::algebra
