// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/core.h>

#include <concepts>
#include <nlohmann/json.hpp>
#include <optional>
#include <ranges>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "algebra/described.h"
#include "algebra/grid.h"
#include "almanac/instant.h"

namespace coppermoon::result {

/// Stands for any visitor that can be passed to `describe`.
struct AnyVisitor {
  void a(std::string_view name, std::string_view meaning);
  template <class... Value>
  void operator()(const Value&... value);
};

/// A type of result for which there is a function `describe`.
template <class Result>
concept Described = requires(AnyVisitor visitor, const Result& result) {
  describe(visitor, result);
};

template <class Value, template <class...> class Template>
inline constexpr bool is_a = false;
template <template <class...> class Template, class... Of>
inline constexpr bool is_a<Template<Of...>, Template> = true;

template <class Value>
inline constexpr bool is_by_name = false;
template <class Value>
inline constexpr bool is_by_name<algebra::ByName<Value>> = true;

/// Kind of a value in JSON documents and in Python.
enum class Kind { truth, whole, number, text, word, instant, numbers, list, by_name, object };

/// Description of one value in a result.
struct Field {
  std::string key{};
  Kind kind = Kind::number;
  Kind of = Kind::number;  ///< kind of each value in a `list` or `by_name`
  std::string unit{}, meaning{};
  bool may_be_none = false;    ///< the value may be null or left out
  bool may_be_absent = false;  ///< a missing value is left out, not written as null
  int axes = 0;                ///< number of axes of an array of `numbers`
  std::vector<std::string> words{};
  std::string type{};          ///< name of the result type, for an `object` or a list of them
  std::vector<Field> parts{};  ///< fields of that result type
};

/// Description of a result type: its name, its meaning and its fields.
struct Fields {
  std::string name, meaning;
  std::vector<Field> all;
  bool many = false;  ///< whether the document is a list of such results
};

template <Described Result>
Fields fields_of();

/// Meaning of a field, followed by its unit in brackets.
std::string meaning_of(const Field& field);

/// Description of a result as JSON: `meaning`, `many`, and `fields`, each with `key`, `kind`, `of`, `unit`, `words`,
/// `may_be`, `meaning` and `fields` as far as they apply.
nlohmann::ordered_json as_json(const Fields& fields);

namespace detail {

template <class Value>
void set_kind(Field& field);

template <class Value>
void set_part(Field& field) {
  Field part;
  set_kind<Value>(part);
  field.of = part.kind;
  field.words = part.words;
  field.type = part.type;
  field.parts = part.parts;
}

template <class Value>
void set_kind(Field& field) {
  if constexpr (is_a<Value, std::optional> || is_a<Value, algebra::IfAny>) {
    if constexpr (is_a<Value, std::optional>)
      set_kind<typename Value::value_type>(field);
    else
      set_kind<typename decltype(Value::value)::value_type>(field);
    field.may_be_none = true;
    field.may_be_absent = is_a<Value, algebra::IfAny> || field.kind == Kind::object;
  } else if constexpr (std::is_same_v<Value, nlohmann::ordered_json>) {
    field.kind = Kind::object;
  } else if constexpr (std::is_same_v<Value, bool>) {
    field.kind = Kind::truth;
  } else if constexpr (std::is_integral_v<Value>) {
    field.kind = Kind::whole;
  } else if constexpr (std::is_floating_point_v<Value> || std::is_same_v<Value, algebra::Angle>) {
    field.kind = Kind::number;
  } else if constexpr (std::is_same_v<Value, algebra::Word>) {
    field.kind = Kind::word;
  } else if constexpr (std::is_convertible_v<Value, std::string_view>) {
    field.kind = Kind::text;
  } else if constexpr (std::is_same_v<Value, almanac::Instant>) {
    field.kind = Kind::instant;
  } else if constexpr (is_a<Value, algebra::Grid>) {
    field.kind = Kind::numbers;
    field.axes = 2;
  } else if constexpr (is_by_name<Value>) {
    field.kind = Kind::by_name;
    set_part<typename Value::value_type::second_type>(field);
  } else if constexpr (Described<Value>) {
    const auto fields = fields_of<Value>();
    field.kind = Kind::object;
    field.type = fields.name;
    field.parts = fields.all;
  } else if constexpr (std::is_same_v<std::ranges::range_value_t<Value>, double>) {
    field.kind = Kind::numbers;
    field.axes = 1;
  } else {
    field.kind = Kind::list;
    set_part<std::ranges::range_value_t<Value>>(field);
  }
}

/// Visitor for `describe` that records the fields of a result, whatever their values.
struct TakesDown {
  Fields fields;

  /// Keeps the first name. Any later names are those of parts that the result describes with the same visitor.
  void a(std::string_view name, std::string_view meaning) {
    if (!fields.name.empty()) return;
    fields.name = name;
    fields.meaning = meaning;
  }
  template <class Value>
  void operator()(std::string_view key, const Value& value, algebra::Unit unit,
                  std::string_view meaning) {
    if constexpr (std::invocable<Value>) {
      add<std::remove_cvref_t<std::invoke_result_t<Value>>>(key, unit, meaning);
    } else {
      add<Value>(key, unit, meaning);
      if constexpr (std::is_same_v<Value, algebra::Word>)
        fields.all.back().words.assign(value.allowed.begin(), value.allowed.end());
    }
  }
  template <class Value>
  void operator()(std::string_view key, const Value& value, std::string_view meaning) {
    (*this)(key, value, algebra::unit::none, meaning);
  }

 private:
  template <class Value>
  void add(std::string_view key, algebra::Unit unit, std::string_view meaning) {
    auto& field = fields.all.emplace_back();
    field.key = key;
    field.unit = unit.name;
    field.meaning = meaning;
    set_kind<Value>(field);
  }
};

}  // namespace detail

/// Fields of a result type, found by describing a default value.
template <Described Result>
Fields fields_of() {
  detail::TakesDown taken;
  describe(taken, Result{});
  return taken.fields;
}

/// Fields of the results in a list.
template <Described Result>
Fields fields_of_each() {
  auto fields = fields_of<Result>();
  fields.many = true;
  return fields;
}

}  // namespace coppermoon::result
