// SPDX-License-Identifier: MIT
// Requests of the library as Python classes: every field a keyword, by the name and in the unit of the command's option.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "wrappers/python/arguments.h"

namespace coppermoon::python {

/// A field of a request.
template <class Request>
struct Field {
  const char* name;
  const char* text;  ///< for its docstring
  std::function<void(Request&, py::handle)> set;
  std::function<py::object(const Request&)> get;
};

/// A value of Python's as one of ours; None where the field may be without. Of a switch True and False
/// alone: a text would count as on.
///
/// Throws  type_error  when it is of another kind
template <class Value>
Value read_as(const char* name, py::handle value) {
  if constexpr (std::is_same_v<Value, bool> || std::is_same_v<Value, std::optional<bool>>) {
    const bool empty = value.is_none() && !std::is_same_v<Value, bool>;
    if (!py::isinstance<py::bool_>(value) && !empty)
      throw py::type_error(
          fmt::format("{} = {}, allowed True or False", name, py::repr(value).cast<std::string>()));
  }
  try {
    return value.cast<Value>();
  } catch (const py::cast_error&) {
    throw py::type_error(fmt::format("{} = {}: a value of another kind is expected", name,
                                     py::repr(value).cast<std::string>()));
  }
}

/// The field that `place` finds in a request.
template <class Request, class Place>
Field<Request> field(const char* name, Place place, const char* text) {
  using Value = std::remove_cvref_t<decltype(place(std::declval<Request&>()))>;
  return {name, text,
          [=](Request& request, py::handle value) { place(request) = read_as<Value>(name, value); },
          [=](const Request& request) -> py::object {
            return py::cast(place(const_cast<Request&>(request)));
          }};
}

/// A request with the fields that keywords name.
///
/// Throws  type_error  for a keyword that is no field
template <class Request>
Request request_of(const char* type, const std::vector<Field<Request>>& fields,
                   const py::kwargs& keywords) {
  Request request{};
  for (const auto& [key, value] : keywords) {
    const auto name = key.template cast<std::string>();
    const auto named = std::ranges::find_if(fields, [&](const auto& f) { return name == f.name; });
    if (named == fields.end())
      throw py::type_error(fmt::format("{}() got an unexpected keyword argument '{}'", type, name));
    named->set(request, value);
  }
  return request;
}

/// "Air(*, atmosphere='standard', …)" with the defaults, and a line for each field.
template <class Request>
std::string docstring_of(const char* type, const std::vector<Field<Request>>& fields,
                         const std::string& text) {
  std::string signature, lines;
  for (const auto& each : fields) {
    signature +=
        fmt::format(", {}={}", each.name, py::repr(each.get({})).template cast<std::string>());
    lines += fmt::format("{}: {}\n", each.name, each.text);
  }
  return fmt::format("{}(*{})\n\n{}\n\n{}", type, signature, text, lines);
}

/// "Air(ozone_du=250.0)": what differs from the default.
template <class Request>
std::string shown(const char* type, const std::vector<Field<Request>>& fields,
                  const Request& request) {
  std::string text;
  for (const auto& each : fields) {
    const auto value = each.get(request);
    if (!value.equal(each.get({})))
      text += fmt::format("{}{}={}", text.empty() ? "" : ", ", each.name,
                          py::repr(value).template cast<std::string>());
  }
  return fmt::format("{}({})", type, text);
}

/// The class of a request: made from keywords, its fields read-only.
template <class Request>
py::class_<Request> class_of(py::module_& package, const char* type,
                             std::vector<Field<Request>> fields, const std::string& text) {
  const auto doc = docstring_of(type, fields, text);
  py::class_<Request> made(package, type, doc.c_str());
  made.def(py::init(
      [type, fields](const py::kwargs& keywords) { return request_of(type, fields, keywords); }));
  for (const auto& each : fields) made.def_property_readonly(each.name, each.get, each.text);
  made.def("__repr__",
           [type, fields](const Request& request) { return shown(type, fields, request); });
  return made;
}

}  // namespace coppermoon::python
