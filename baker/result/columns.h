// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "result/fields.h"

namespace coppermoon::result {

/// Name of a column, and its numbers, one per row.
using Column = std::pair<std::string, std::vector<double>>;

namespace detail {

/// Visitor for `describe` that adds a result's numbers to columns, the k-th number to the k-th column.
struct Gathers {
  std::vector<Column>& columns;
  std::size_t next = 0;

  void a(std::string_view, std::string_view) const {}
  template <class Value>
  void operator()(std::string_view key, const Value& value, const auto&... /*unit, meaning*/) {
    if constexpr (std::is_floating_point_v<Value>)
      add(key, value);
    else if constexpr (std::is_same_v<Value, algebra::Angle>)
      add(key, algebra::in_degrees(value));
    else if constexpr (std::is_same_v<Value, std::optional<double>>)
      add(key, value.value_or(std::numeric_limits<double>::quiet_NaN()));
    else if constexpr (std::is_same_v<Value, std::optional<algebra::Angle>>)
      add(key, value ? algebra::in_degrees(*value) : std::numeric_limits<double>::quiet_NaN());
  }

 private:
  void add(std::string_view key, double number) {
    if (next == columns.size()) columns.emplace_back(key, std::vector<double>{});
    columns[next++].second.push_back(number);
  }
};

}  // namespace detail

/// Collects the numbers in a list of results as columns. Missing numbers become NaN; angles are in degrees.
template <class Results>
std::vector<Column> columns_of(const Results& results) {
  std::vector<Column> columns;
  for (const auto& result : results) describe(detail::Gathers{columns}, result);
  return columns;
}

}  // namespace coppermoon::result
