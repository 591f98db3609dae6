// SPDX-License-Identifier: MIT
#include "wrappers/python/fields.h"

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

#include "algebra/error.h"
#include "uses/light/light_parameters.h"

namespace coppermoon::python {
namespace {

using request::Kind, request::Parameter, request::Parameters, request::Texts;

[[noreturn]] void refuse(const Parameter& parameter, py::handle value, const char* allowed) {
  throw py::type_error(fmt::format("{} = {}, allowed {}", name_of(parameter),
                                   py::repr(value).cast<std::string>(), allowed));
}

template <class Value>
Value read_as(const Parameter& parameter, py::handle value, const char* allowed) {
  try {
    return value.cast<Value>();
  } catch (const py::cast_error&) {
    refuse(parameter, value, allowed);
  }
}

bool is_text(py::handle value) { return py::isinstance<py::str>(value); }

/// Converts a Python number to text.
///
/// Throws  Error  if the number is outside the parameter's range, or not finite
template <class Number>
std::string number_text(const Parameter& parameter, py::handle value, const char* allowed) {
  const auto number = read_as<Number>(parameter, value, allowed);
  const auto size = static_cast<double>(number);
  if (parameter.range)
    algebra::require_within(name_of(parameter), size, parameter.range->low, parameter.range->high);
  if (!std::isfinite(size))
    throw algebra::Error(fmt::format("{} = {}, allowed a finite number", name_of(parameter), size));
  return request::text_of(number);
}

std::string text_of(const Parameter& parameter, py::handle value) {
  switch (parameter.kind) {
    case Kind::number:
      return number_text<double>(parameter, value, "a number");
    case Kind::whole:
      return number_text<int>(parameter, value, "whole numbers");
    case Kind::natural:
      return number_text<std::size_t>(parameter, value, "whole numbers, 0 or more");
    case Kind::word:
      if (!is_text(value) && request::fault_in(Kind::whole, parameter.words.front()).empty())
        return request::text_of(read_as<int>(parameter, value, "whole numbers"));
      break;
    case Kind::text:  // may also be given as a number
      if (!is_text(value)) return request::text_of(read_as<double>(parameter, value, "a text"));
      break;
    case Kind::file_read:
      return read_as<std::filesystem::path>(parameter, value, "a path").string();
    default:
      break;
  }
  return read_as<std::string>(parameter, value, "a text");
}

Texts texts_of(const Parameter& parameter, py::handle value) {
  if (parameter.parts) {
    uses::Air air{.regions =
                      read_as<std::vector<uses::AirRegion>>(parameter, value, "a list of Region")};
    return parameters_of(air).find(parameter.name)->texts();
  }
  const bool presence = parameter.kind == Kind::presence;
  if (!presence && parameter.kind != Kind::on_off) return {text_of(parameter, value)};
  const bool of_numpy = py::isinstance(value, py::module_::import("numpy").attr("bool_"));
  if (!of_numpy && !py::isinstance<py::bool_>(value)) refuse(parameter, value, "True or False");
  const bool on = value.cast<bool>();
  if (presence) return on ? Texts{"true"} : Texts{};
  return {on ? "on" : "off"};
}

void take_value(Parameter& parameter, py::handle value) {
  if (value.is_none() && may_be_none(parameter)) {
    if (parameter.has_value()) parameter.write({});
    return;
  }
  try {
    parameter.take(texts_of(parameter, value));
  } catch (const algebra::Error& error) {  // its message spells the name as recipes do: "ozone-du"
    const std::string why = error.what();
    const bool named = why.starts_with(parameter.name + " ");
    throw algebra::Error(named ? name_of(parameter) + why.substr(parameter.name.size()) : why);
  }
}

}  // namespace

void take(Parameters parameters, const std::string& function, const py::dict& keywords) {
  for (const auto& [key, value] : keywords) {
    const auto keyword = key.cast<std::string>();
    const auto named = std::ranges::find(parameters, keyword, name_of);
    if (named == parameters.end())
      throw py::type_error(
          fmt::format("{}() got an unexpected keyword argument '{}'", function, keyword));
    take_value(*named, value);
  }
  for (const auto& line :
       without_effect(parameters, name_of, [](const Parameter&) { return true; }))
    if (PyErr_WarnEx(PyExc_UserWarning, line.c_str(), 1) != 0) throw py::error_already_set();
}

py::object value_of(const Parameter& parameter) {
  if (!parameter.parts)
    return py::module_::import("ast").attr("literal_eval")(literal_of(parameter));
  std::vector<uses::AirRegion> regions;
  for (const auto& text : parameter.texts()) regions.push_back(uses::region_from(text));
  return py::cast(regions);
}

}  // namespace coppermoon::python
