// SPDX-License-Identifier: MIT
// Vocabulary for results that describe themselves. Beside each result type stands a function
//
//     template <class Field>
//     void describe(Field&& is, const Result& result);
//
// which calls `is.a(name, meaning)` for the result, and `is(key, value, unit, meaning)` for each of its values; the
// unit may be left out. A value is a number, a string, an Angle (in degrees), an Instant, a list, a grid, another
// result, a type from this file, an optional of these, or a function without arguments that returns one of them.
// `describe` is also called with a result of default values, just to learn the keys, kinds, units and meanings.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "algebra/quantity.h"

namespace coppermoon::algebra {

/// The unit of a value, as written in documents.
struct Unit {
  std::string_view name;
};

namespace unit {
inline constexpr Unit none{""}, degrees{"degrees"}, metres{"m"}, kilometres{"km"}, au{"au"},
    earth_radii{"Earth radii"}, nanometres{"nm"}, seconds{"s"}, days{"days"}, mag{"mag"},
    luminance{"cd/m²"}, illuminance{"lx"}, stops{"stops"}, pixels{"pixels"}, bytes{"bytes"};
}  // namespace unit

/// An optional value. If it is missing, documents leave out its key; for a plain std::optional they write null instead.
template <class Value>
struct IfAny {
  std::optional<Value> value;
};

template <class Value>
IfAny<Value> if_any(std::optional<Value> value) {
  return {std::move(value)};
}

/// A value of an optional thing. Documents leave out its key if the thing is missing, and write null if the thing has
/// no such value.
///
/// Given  thing  optional, or a pointer
///        value  function of the thing, or a pointer to its member
template <class Thing, class Function>
auto of_any(const Thing& thing, Function&& value) {
  using Value = std::remove_cvref_t<std::invoke_result_t<Function, decltype(*thing)>>;
  return IfAny<Value>{thing ? std::optional<Value>(std::in_place, std::invoke(value, *thing))
                            : std::nullopt};
}

/// Named values, which become an object in documents.
template <class Value>
using ByName = std::vector<std::pair<std::string, Value>>;

/// A word, and all words that are allowed.
struct Word {
  std::string_view word;
  std::vector<std::string_view> allowed;
};

/// Converts an optional angle to degrees.
inline std::optional<double> in_degrees(const std::optional<Angle>& angle) {
  return angle ? std::optional(in_degrees(*angle)) : std::nullopt;
}

}  // namespace coppermoon::algebra
