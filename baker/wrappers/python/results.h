// SPDX-License-Identifier: MIT
// Makes Python classes with properties, docstrings, repr, equality and pickling from results that describe themselves.
#pragma once

#include <fmt/format.h>
#include <pybind11/pybind11.h>

#include <string>
#include <utility>

#include "result/fields.h"
#include "texture/image.h"
#include "wrappers/python/arguments.h"

namespace coppermoon::python {

/// A result as its Python object stores it: a dictionary of the values that the result describes. Instants are stored
/// as text, because a datetime can only hold the years 1 to 9999.
template <class Result>
struct Told {
  py::dict values;
};

/// Converts a result to the form in which its Python object stores it.
template <result::Described Result>
Told<Result> told(const Result& result);

/// Converts one of a result's values to the Python object that is stored in Told::values.
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

/// Visitor for `describe` that stores a result's values in a dictionary.
struct Keeps {
  py::dict& values;

  void a(std::string_view, std::string_view) const {}
  template <class Value>
  void operator()(std::string_view key, const Value& value,
                  const auto&... /*unit, meaning*/) const {
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

/// The value of a result's property. An instant, which is stored as text, becomes a datetime.
///
/// Throws  Error  if datetime_of does
py::object shown(const result::Field& field, const py::dict& values);

/// A result as text, such as "Eclipse(type='total', gamma=0.117)". Values that are None are left out, and only the
/// shape of arrays is shown.
std::string text_of(const std::string& type, const py::dict& values);

/// Whether two stored values are equal. Arrays are compared byte by byte, and results value by value.
bool are_equal(py::handle a, py::handle b);

/// Adds a Python class for results, with a property for each field.
template <class Kept>
py::class_<Kept> add_kept(py::module_& package, const result::Fields& fields) {
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

/// Adds the Python class of a result that describes itself.
template <result::Described Result>
py::class_<Told<Result>> add_result(py::module_& package) {
  return add_kept<Told<Result>>(package, result::fields_of<Result>());
}

/// Lets NumPy treat an object as the array that the object stores under the given key.
template <class Kept>
void add_array_protocol(py::class_<Kept>& made, const char* key) {
  using namespace py::literals;
  made.def(
      "__array__",
      [key](const Kept& kept, const py::object& dtype, std::optional<bool> copy) {
        return converted(kept.values[key], dtype, copy);
      },
      "dtype"_a = py::none(), "copy"_a = py::none());
}

/// The values in a file's header, by name.
inline py::dict header_of(const texture::Attributes& attributes) {
  py::dict header;
  for (const auto& [name, value] : attributes) header[py::str(name)] = value;
  return header;
}

}  // namespace coppermoon::python
