// SPDX-License-Identifier: MIT
// Types for results that describe themselves. For each type of result there is a function
//
//     template <class Field>
//     void describe(Field&& is, const Result& result);
//
// which calls `is.a(name, meaning)` for the result, and `is(key, value, unit, meaning)` for each of its values; the
// unit may be left out. A value is a number, a string, an Angle (in degrees), an Instant, a list, a grid, another
// result, a type from this file, an optional of these, or a function without arguments that returns one of them.
// `describe` is also called with a default-constructed result, only to learn the keys, kinds, units and meanings.
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

/// Unit of a value, as written in documentation and JSON.
struct Unit {
  std::string_view name;
};

namespace unit {
inline constexpr Unit none{""}, degrees{"degrees"}, metres{"m"}, kilometres{"km"}, au{"au"},
    earth_radii{"Earth radii"}, nanometres{"nm"}, seconds{"s"}, days{"days"}, mag{"mag"},
    luminance{"cd/m²"}, illuminance{"lx"}, stops{"stops"}, pixels{"pixels"}, bytes{"bytes"};
}  // namespace unit

/// Optional value. If it is missing, JSON leaves out its key, whereas a missing plain std::optional is written as null.
template <class Value>
struct IfAny {
  std::optional<Value> value;
};

template <class Value>
IfAny<Value> if_any(std::optional<Value> value) {
  return {std::move(value)};
}

/// Value that belongs to an optional object. JSON leaves out the key if the object is missing, and writes null if the
/// object exists but has no such value.
///
/// Given  thing  the object: a std::optional, or a pointer
///        value  function of the object, or a pointer to one of its members
template <class Thing, class Function>
auto of_any(const Thing& thing, Function&& value) {
  using Value = std::remove_cvref_t<std::invoke_result_t<Function, decltype(*thing)>>;
  return IfAny<Value>{thing ? std::optional<Value>(std::in_place, std::invoke(value, *thing))
                            : std::nullopt};
}

/// Named values, which become an object in JSON.
template <class Value>
using ByName = std::vector<std::pair<std::string, Value>>;

/// A word from a fixed set, together with all words of that set.
struct Word {
  std::string_view word;
  std::vector<std::string_view> allowed;
};

inline std::optional<double> in_degrees(const std::optional<Angle>& angle) {
  return angle ? std::optional(in_degrees(*angle)) : std::nullopt;
}

}  // namespace coppermoon::algebra
