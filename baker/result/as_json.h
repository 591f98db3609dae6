// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "almanac/calendar.h"
#include "result/fields.h"

namespace coppermoon::result {

using Json = nlohmann::ordered_json;

/// How values are written as JSON.
struct Style {
  almanac::Calendar calendar = almanac::Calendar::gregorian;  ///< calendar used for dates
  bool as_row = false;  ///< write every key, with null for a missing value
  int decimals = 0;     ///< decimal places in the seconds of an instant
};

/// A result as a JSON object, with keys in the order of its description. Numbers that are not finite become null.
template <Described Result>
Json as_json(const Result& result, const Style& style = {});

/// Converts to JSON a value of any kind that a result may contain.
template <class Value>
Json json_of(const Value& value, const Style& style) {
  if constexpr (std::is_same_v<Value, Json>) {
    return value;
  } else if constexpr (is_a<Value, std::optional>) {
    return value ? json_of(*value, style) : Json();
  } else if constexpr (is_a<Value, algebra::IfAny>) {
    return json_of(value.value, style);
  } else if constexpr (std::is_same_v<Value, algebra::Angle>) {
    return json_of(algebra::in_degrees(value), style);
  } else if constexpr (std::is_floating_point_v<Value>) {
    return std::isfinite(value) ? Json(value) : Json();
  } else if constexpr (std::is_same_v<Value, algebra::Word>) {
    return value.word;
  } else if constexpr (std::is_same_v<Value, almanac::Instant>) {
    return almanac::utc_text(value, style.calendar, style.decimals);
  } else if constexpr (is_by_name<Value>) {
    auto all = Json::object();
    for (const auto& [name, each] : value) all[name] = json_of(each, style);
    return all;
  } else if constexpr (is_a<Value, algebra::Grid>) {
    auto rows = Json::array();
    for (std::size_t r = 0; r < value.rows(); ++r) rows.push_back(value.row(r));
    return rows;
  } else if constexpr (Described<Value>) {
    return as_json(value, style);
  } else if constexpr (std::ranges::range<Value> &&
                       !std::is_convertible_v<Value, std::string_view>) {
    auto all = Json::array();
    for (const auto& each : value) all.push_back(json_of(each, style));
    return all;
  } else {
    return value;
  }
}

namespace detail {

/// Visitor for `describe` that writes a result's values into a JSON object.
struct Writes {
  Json& json;
  const Style& style;

  void a(std::string_view, std::string_view) const {}
  template <class Value>
  void operator()(std::string_view key, const Value& value,
                  const auto&... /*unit, meaning*/) const {
    if constexpr (std::invocable<Value>) {
      (*this)(key, value());
    } else if constexpr (is_a<Value, algebra::IfAny>) {
      if (value.value)
        write(key, *value.value);
      else if (style.as_row)
        write(key, Json());
    } else if constexpr (is_a<Value, std::optional>) {
      if constexpr (Described<typename Value::value_type>) {
        if (value) write(key, *value);
      } else {
        write(key, value);
      }
    } else {
      write(key, value);
    }
  }

 private:
  template <class Value>
  void write(std::string_view key, const Value& value) const {
    json[std::string(key)] = json_of(value, style);
  }
};

}  // namespace detail

template <Described Result>
Json as_json(const Result& result, const Style& style) {
  auto json = Json::object();
  describe(detail::Writes{json, style}, result);
  return json;
}

/// Converts rows to CSV with a header line. Rows are flat objects with the same keys; null becomes an empty cell.
std::string as_csv(const Json& rows);

/// Converts results to CSV, with one row for each result.
template <class Results>
requires Described<std::ranges::range_value_t<Results>> std::string as_csv(const Results& results,
                                                                           Style style = {}) {
  style.as_row = true;
  return as_csv(json_of(results, style));
}

/// An object as text for a terminal, with a key and its value on each line.
///
/// Given  number  format for numbers, such as "{:.6f}"
std::string as_lines(const Json& object, const std::string& number);

}  // namespace coppermoon::result
