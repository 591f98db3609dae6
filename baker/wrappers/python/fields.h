// SPDX-License-Identifier: MIT
// Makes keyword arguments and fields of Python classes from the parameters of requests.
#pragma once

#include <fmt/format.h>
#include <pybind11/pybind11.h>

#include <string>

#include "wrappers/python/described.h"

namespace coppermoon::python {

namespace py = pybind11;

/// Sets parameters from keyword arguments. Warns about those that have no effect in combination with the others.
///
/// Given   function    name of the Python function, for error messages
/// Throws  type_error  if a keyword is unknown or a value has the wrong type
///         Error       if a value is not allowed
void take(request::Parameters parameters, const std::string& function, const py::dict& keywords);

/// The value of a parameter as a Python object: a number, a bool, a string, a list of regions, or None.
py::object value_of(const request::Parameter& parameter);

/// Adds a Python class for a request. Its objects are made from keyword arguments, and their fields are read-only.
template <class Request>
void add_class(py::module_& package, const char* type, const std::string& text) {
  Request fresh;
  const auto fields = parameters_of(fresh);
  const auto doc =
      fmt::format("{}(*, {})\n\n{}\n\n{}", type, signature_of(fields), text, lines_of(fields));
  py::class_<Request> made(package, type, doc.c_str());
  made.def(py::init([type](const py::kwargs& keywords) {
    Request request;
    take(parameters_of(request), type, keywords);
    return request;
  }));
  for (const auto& field : fields)
    made.def_property_readonly(
        name_of(field).c_str(),
        [name = field.name](Request request) {
          return value_of(*parameters_of(request).find(name));
        },
        meaning_of(field).c_str());
  const auto shown = [type](const Request& request) { return text_of(type, request); };
  made.def("__repr__", shown);
  made.def(
      "__eq__", [shown](const Request& a, const Request& b) { return shown(a) == shown(b); },
      py::is_operator());
  made.def("__hash__",
           [shown](const Request& request) { return py::hash(py::str(shown(request))); });
  made.def(py::pickle(
      [](Request request) {
        Request untouched;
        const auto usual = parameters_of(untouched);
        py::dict values;
        for (const auto& field : parameters_of(request))
          if (field.texts() != usual.find(field.name)->texts())
            values[name_of(field).c_str()] = value_of(field);
        return values;
      },
      [type](const py::dict& values) {
        Request request;
        take(parameters_of(request), type, values);
        return request;
      }));
}

}  // namespace coppermoon::python
