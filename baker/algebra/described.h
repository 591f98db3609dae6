// SPDX-License-Identifier: MIT
// Words of a result that describes itself. Beside each result stands
//
//     template <class Field>
//     void describe(Field&& is, const Result& result);
//
// which calls `is.a(name, meaning)` for the result, and `is(key, value, unit, meaning)` for each of its values; the unit may be
// left out. A value is a number, a text, an Angle (in degrees), an Instant, a list, a grid, another result, something
// below, an optional of these, or a function without arguments that returns one. `describe` is also called with a
// result of default values, of which keys, kinds, units and meanings are taken.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "algebra/quantity.h"

namespace coppermoon::algebra {

/// Unit of a value, as documents write it.
struct Unit {
  std::string_view name;
};

namespace unit {
inline constexpr Unit none{""}, degrees{"degrees"}, metres{"m"}, kilometres{"km"}, au{"au"},
    earth_radii{"Earth radii"}, nanometres{"nm"}, seconds{"s"}, days{"days"}, mag{"mag"},
    luminance{"cd/m²"}, illuminance{"lx"}, stops{"stops"}, pixels{"pixels"}, bytes{"bytes"};
}  // namespace unit

/// Optional whose key documents leave out where it has no value; that of others is null.
template <class Value>
struct IfAny {
  std::optional<Value> value;
};

template <class Value>
IfAny<Value> if_any(std::optional<Value> value) {
  return {std::move(value)};
}

/// Values by their names: an object in documents.
template <class Value>
using ByName = std::vector<std::pair<std::string, Value>>;

/// One of some words.
struct Word {
  std::string_view word;
  std::vector<std::string_view> allowed;
};

/// Value in degrees, of an angle that there may be.
inline std::optional<double> in_degrees(const std::optional<Angle>& angle) {
  return angle ? std::optional(in_degrees(*angle)) : std::nullopt;
}

}  // namespace coppermoon::algebra
