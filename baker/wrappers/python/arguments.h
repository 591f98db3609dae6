// SPDX-License-Identifier: MIT
// Conversion of Python's arguments: moments, places, words, arrays. Sources that take or give one of them include it.
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

/// Moment of an eclipse: a datetime with a time zone, an ISO 8601 text, NumPy's datetime64 (UTC), a day, which stands for
/// its greatest eclipse, or a day and a contact, moonrise or moonset.
struct Moment {
  std::string text;
  std::optional<almanac::Instant> instant{};  ///< of a datetime, which has no text

  /// Throws  Error  as uses::moment_in
  almanac::Instant seen_from(const std::optional<almanac::Observer>& observer) const {
    return instant ? *instant : uses::moment_in(text, {observer});
  }
};

/// End of a search, or its middle: as Moment; but a day alone is its midnight.
struct Date {
  almanac::Instant instant;
};

/// A place on the Earth: the name of a city, or latitude, longitude and elevation [degrees, m].
struct Place {
  almanac::Observer observer;
};

/// Throws  Error       when it is no such moment; datetimes without a time zone are none
///         type_error  when it is of another type
almanac::Instant instant_of(py::handle moment);
Moment moment_of(py::handle moment);
almanac::Instant instant_of_date(py::handle date);

/// A datetime in UTC, to the millisecond.
///
/// Throws  Error  outside of the years 1 to 9999, which are all that a datetime knows
py::object datetime_of(const almanac::Instant& instant);

/// The same of utc_text's text, with milliseconds.
py::object datetime_of(const std::string& text);

/// Throws  Error  when no city has that name, or a number is outside its range
almanac::Observer observer_of(py::handle place);

/// Numbers along one axis.
///
/// Throws  Error       when they have more axes or none
///         type_error  when they are no numbers
std::vector<double> numbers_of(const char* what, py::handle numbers);

/// An array by NumPy's protocol `__array__`.
///
/// Given   dtype  None: the array's own
///         copy   true: always; none: where the dtype needs one
/// Throws  Error  when copy is false and the dtype needs one
py::object converted(const py::object& array, const py::object& dtype, std::optional<bool> copy);

/// Words of an enumeration: those of the command's options.
template <class Value>
struct Words;

template <class Value>
concept HasWords = requires {
  Words<Value>::all;
};

template <>
struct Words<eclipse::ShadowConvention> {
  static constexpr std::string_view what = "convention";
  static constexpr std::array all{
      std::pair{"danjon", eclipse::ShadowConvention::danjon},
      std::pair{"danjon-oblate", eclipse::ShadowConvention::danjon_oblate},
      std::pair{"chauvenet", eclipse::ShadowConvention::chauvenet},
      std::pair{"herald-sinnott", eclipse::ShadowConvention::herald_sinnott}};
};

template <>
struct Words<texture::Coding> {
  static constexpr std::string_view what = "coding";
  static constexpr std::array all{std::pair{"as-file-says", texture::Coding::as_file_says},
                                  std::pair{"srgb", texture::Coding::srgb},
                                  std::pair{"linear", texture::Coding::linear},
                                  std::pair{"camera", texture::Coding::camera}};
};

/// Throws  Error  when the word is none of them: names them
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

/// An array that owns what it is made from: nothing is copied.
///
/// Given  numbers  whatever has data(), of the shape's size
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
