// SPDX-License-Identifier: MIT
// Converts moments, places, words and arrays from and to Python. Include it wherever functions take or return them.
#pragma once

#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "algebra/error.h"
#include "algebra/grid.h"
#include "almanac/instant.h"
#include "almanac/observer.h"
#include "eclipse/contacts.h"
#include "texture/read_image.h"
#include "uses/picture/moment_text.h"

namespace coppermoon::python {

namespace py = pybind11;

/// A moment of an eclipse, given as a datetime with a time zone, NumPy's datetime64 (UTC), an ISO 8601 string, or a day
/// with a contact, moonrise or moonset. A day alone stands for the greatest eclipse on that day.
struct Moment {
  std::string text;
  std::optional<almanac::Instant> instant{};  ///< set instead of `text` for a datetime

  /// The instant of this moment. Moonrise and moonset need an observer. Throws Error if uses::moment_in does.
  almanac::Instant seen_from(const std::optional<almanac::Observer>& observer) const {
    return instant ? *instant : uses::moment_in(text, {observer});
  }
};

/// The date at which a search starts, ends or is centred. It is given like a Moment, but a day alone means its 0 h UTC.
struct Date {
  almanac::Instant instant;
};

/// A place on the Earth: the name of a city, or latitude, longitude and elevation [degrees, m].
struct Place {
  almanac::Observer observer;
};

/// Throws  Error       if the moment is not valid, such as a datetime without a time zone
///         type_error  if the moment has a type that is not allowed
almanac::Instant instant_of(py::handle moment);
Moment moment_of(py::handle moment);
almanac::Instant instant_of_date(py::handle date);

/// Converts an instant to a datetime in UTC, to the millisecond.
///
/// Throws  Error  if the year is outside 1 to 9999, because a datetime cannot hold it
py::object datetime_of(const almanac::Instant& instant);

/// Converts a UTC time with milliseconds, as utc_text writes it, to a datetime.
py::object datetime_of(const std::string& text);

/// Throws  Error  if no city has the name, or a number is out of range
almanac::Observer observer_of(py::handle place);

/// Reads numbers from a one-dimensional array.
///
/// Throws  Error       if the array does not have exactly one axis
///         type_error  if the values are not numbers
std::vector<double> numbers_of(const char* what, py::handle numbers);

/// Converts an array as NumPy's protocol `__array__` requires.
///
/// Given   dtype  None keeps the array's own dtype
///         copy   true always copies; nullopt copies only if the dtype requires it
/// Throws  Error  if `copy` is false and the dtype requires a copy
py::object converted(const py::object& array, const py::object& dtype, std::optional<bool> copy);

/// The words that stand for the values of an enumeration. The program's command-line options use the same words.
template <class Value>
struct Words;

template <class Value>
concept HasWords = requires {
  Words<Value>::all;
};

template <>
struct Words<eclipse::ShadowConvention> {
  static constexpr std::string_view what = "convention";
  static constexpr auto all = eclipse::convention_words;
};

template <>
struct Words<texture::Coding> {
  static constexpr std::string_view what = "coding";
  static constexpr auto all = texture::coding_words;
};

/// Throws  Error  if the word is not allowed; the message lists the allowed words
template <HasWords Value>
Value value_of(std::string_view word) {
  std::string allowed;
  for (const auto& [name, value] : Words<Value>::all) {
    if (word == name) return value;
    allowed += allowed.empty() ? name : fmt::format(", {}", name);
  }
  throw algebra::Error(fmt::format("{} = {}, allowed {}", Words<Value>::what, word, allowed));
}

template <HasWords Value>
const char* word_of(Value value) {
  for (const auto& [name, each] : Words<Value>::all)
    if (value == each) return name;
  return "none";
}

/// A NumPy array that takes over the object that holds its numbers, so that nothing is copied.
///
/// Given  numbers  an object that has data() or values(), with as many elements as the shape
template <class Number, class Owner>
py::array_t<Number> array_of(Owner&& numbers, std::vector<py::ssize_t> shape) {
  auto* kept = new std::remove_cvref_t<Owner>(std::forward<Owner>(numbers));
  const py::capsule owner(kept,
                          [](void* all) { delete static_cast<std::remove_cvref_t<Owner>*>(all); });
  Number* first = nullptr;
  if constexpr (requires { kept->data(); })
    first = kept->data();
  else
    first = kept->values().data();
  return py::array_t<Number>(std::move(shape), first, owner);
}

inline py::array_t<double> array_of(std::vector<double> numbers) {
  const auto size = static_cast<py::ssize_t>(numbers.size());
  return array_of<double>(std::move(numbers), {size});
}

inline py::array_t<double> array_of(algebra::Grid<double> grid) {
  const auto rows = static_cast<py::ssize_t>(grid.rows()),
             columns = static_cast<py::ssize_t>(grid.columns());
  return array_of<double>(std::move(grid), {rows, columns});
}

}  // namespace coppermoon::python

namespace pybind11::detail {

template <>
struct type_caster<coppermoon::python::Moment> {
  PYBIND11_TYPE_CASTER(coppermoon::python::Moment,
                       const_name("datetime | date | numpy.datetime64 | str"));
  bool load(handle source, bool) {
    value = coppermoon::python::moment_of(source);
    return true;
  }
};

template <>
struct type_caster<coppermoon::python::Date> {
  PYBIND11_TYPE_CASTER(coppermoon::python::Date,
                       const_name("datetime | date | numpy.datetime64 | str"));
  bool load(handle source, bool) {
    value = {coppermoon::python::instant_of_date(source)};
    return true;
  }
};

template <>
struct type_caster<coppermoon::python::Place> {
  PYBIND11_TYPE_CASTER(coppermoon::python::Place, const_name("str | Sequence[float]"));
  bool load(handle source, bool) {
    value = {coppermoon::python::observer_of(source)};
    return true;
  }
};

template <coppermoon::python::HasWords Value>
struct type_caster<Value> {
  PYBIND11_TYPE_CASTER(Value, const_name("str"));
  bool load(handle source, bool) {
    if (!isinstance<str>(source)) return false;
    value = coppermoon::python::value_of<Value>(source.cast<std::string>());
    return true;
  }
  static handle cast(Value word, return_value_policy, handle) {
    return str(coppermoon::python::word_of(word)).release();
  }
};

}  // namespace pybind11::detail
