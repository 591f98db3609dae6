// SPDX-License-Identifier: MIT
// Results that describe themselves as classes of Python: properties, docstrings, repr, equality, pickling.
#pragma once

#include <fmt/format.h>
#include <pybind11/pybind11.h>

#include <string>
#include <utility>

#include "result/fields.h"
#include "wrappers/python/arguments.h"

namespace coppermoon::python {

/// A result as Python keeps it: the values that it describes, by their keys. An instant is kept as its text, for a
/// datetime knows the years 1 to 9999 alone.
template <class Result>
struct Told {
  py::dict values;
};

/// A result for Python.
template <result::Described Result>
Told<Result> told(const Result& result);

/// A described value as Told keeps it.
template <class Value>
py::object kept(const Value& value) {
  if constexpr (result::is_a<Value, std::optional>) {
    return value ? kept(*value) : py::none();
  } else if constexpr (result::is_a<Value, algebra::IfAny>) {
    return kept(value.value);
  } else if constexpr (std::is_same_v<Value, algebra::Angle>) {
    return py::float_(algebra::in_degrees(value));
  } else if constexpr (std::is_same_v<Value, algebra::Word>) {
    return py::str(std::string(value.word));
  } else if constexpr (std::is_same_v<Value, almanac::Instant>) {
    return py::str(almanac::utc_text(value, 3));
  } else if constexpr (result::is_by_name<Value>) {
    py::dict all;
    for (const auto& [name, each] : value) all[py::str(name)] = kept(each);
    return all;
  } else if constexpr (result::is_a<Value, algebra::Grid>) {
    return array_of(value);
  } else if constexpr (result::Described<Value>) {
    return py::cast(told(value));
  } else if constexpr (std::is_convertible_v<Value, std::string_view> ||
                       !std::ranges::range<Value>) {
    return py::cast(value);
  } else if constexpr (std::is_same_v<std::ranges::range_value_t<Value>, double>) {
    return array_of(std::vector<double>(std::ranges::begin(value), std::ranges::end(value)));
  } else {
    py::list all;
    for (const auto& each : value) all.append(kept(each));
    return all;
  }
}

/// Visitor that keeps the values of a description.
struct Keeps {
  py::dict& values;

  void a(std::string_view, std::string_view) const {}
  template <class Value>
  void operator()(std::string_view key, const Value& value, algebra::Unit,
                  std::string_view meaning) const {
    (*this)(key, value, meaning);
  }
  template <class Value>
  void operator()(std::string_view key, const Value& value, std::string_view) const {
    if constexpr (std::invocable<Value>)
      values[py::str(std::string(key))] = kept(value());
    else
      values[py::str(std::string(key))] = kept(value);
  }
};

template <result::Described Result>
Told<Result> told(const Result& result) {
  Told<Result> made;
  describe(Keeps{made.values}, result);
  return made;
}

/// A kept value as a property shows it: of an instant's text its datetime.
///
/// Throws  Error  as datetime_of
py::object shown(const result::Field& field, const py::dict& values);

/// "Eclipse(type='total', gamma=0.117)": the values that are not None; arrays by their shape.
std::string text_of(const std::string& type, const py::dict& values);

/// Whether two kept values are the same; arrays by their bytes, the values of two results in the order of their keys.
bool are_equal(py::handle a, py::handle b);

/// Class of a result: a property for each of its fields.
template <result::Described Result>
py::class_<Told<Result>> add_result(py::module_& package) {
  using Kept = Told<Result>;
  const auto fields = result::fields_of<Result>();
  py::class_<Kept> made(package, fields.name.c_str(), fields.meaning.c_str());
  for (const auto& field : fields.all)
    made.def_property_readonly(
        field.key.c_str(), [field](const Kept& result) { return shown(field, result.values); },
        result::meaning_of(field).c_str());
  const auto text = [name = fields.name](const Kept& result) {
    return text_of(name, result.values);
  };
  made.def("__repr__", text);
  made.def(
      "__eq__", [](const Kept& a, const Kept& b) { return are_equal(a.values, b.values); },
      py::is_operator());
  made.def("__hash__", [text](const Kept& result) { return py::hash(py::str(text(result))); });
  made.def(py::pickle([](const Kept& result) { return result.values; },
                      [](const py::dict& values) { return Kept{values}; }));
  return made;
}

}  // namespace coppermoon::python
