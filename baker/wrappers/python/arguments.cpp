// SPDX-License-Identifier: MIT
#include "wrappers/python/arguments.h"

#include <cmath>
#include <cstdio>
#include <optional>

#include "almanac/gazetteer.h"
#include "eclipse/moment.h"
#include "uses/picture/place_text.h"

namespace coppermoon::python {
namespace {

py::object utc() { return py::module_::import("datetime").attr("timezone").attr("utc"); }

bool is_of(py::handle object, const char* package, const char* type) {
  return py::isinstance(object, py::module_::import(package).attr(type));
}

/// Text of a moment that is given as a string, a date, or NumPy's datetime64 in UTC. Any other type gives nullopt.
std::optional<std::string> text_of_moment(py::handle moment) {
  if (py::isinstance<py::str>(moment)) return moment.cast<std::string>();
  if (is_of(moment, "datetime", "date") && !is_of(moment, "datetime", "datetime"))
    return moment.attr("isoformat")().cast<std::string>();
  if (!is_of(moment, "numpy", "datetime64")) return std::nullopt;
  const auto text = py::str(moment).cast<std::string>();
  return text.size() == std::size("2018-07-27T20") - 1 ? text + ":00" : text;  // adds the minutes
}

almanac::Instant instant_of_datetime(py::handle moment) {
  if (!is_of(moment, "datetime", "datetime"))
    throw py::type_error(
        fmt::format("{}: no moment, allowed a datetime with a time zone, a date, a datetime64 of "
                    "NumPy, which is UTC, or a text as 2018-07-27T20:21:45Z",
                    py::repr(moment).cast<std::string>()));
  if (moment.attr("utcoffset")().is_none())
    throw algebra::Error(
        fmt::format("{}: a datetime without a time zone, allowed one with, as "
                    "datetime(2018, 7, 27, 20, 21, tzinfo=timezone.utc)",
                    py::str(moment).cast<std::string>()));
  const auto text = moment.attr("astimezone")(utc()).attr("isoformat")();
  return almanac::instant_from_utc(text.cast<std::string>());
}

}  // namespace

almanac::Instant instant_of(py::handle moment) { return moment_of(moment).seen_from({}); }

Moment moment_of(py::handle moment) {
  if (auto text = text_of_moment(moment)) return {std::move(*text)};
  return {"", instant_of_datetime(moment)};
}

almanac::Instant instant_of_date(py::handle date) {
  const auto text = text_of_moment(date);
  return text && eclipse::is_day(*text) ? almanac::instant_from_utc(*text) : instant_of(date);
}

py::object datetime_of(const almanac::Instant& instant) {
  return datetime_of(almanac::utc_text(instant, 3));
}

py::object datetime_of(const std::string& text) {
  int year = 0, month = 0, day = 0, hour = 0, minute = 0, second = 0, millisecond = 0;
  const int read = std::sscanf(text.c_str(), "%4d-%2d-%2dT%2d:%2d:%2d.%3dZ", &year, &month, &day,
                               &hour, &minute, &second, &millisecond);
  if (read != 7 || year < 1)
    throw algebra::Error(
        fmt::format("{}: a datetime of Python cannot hold it, allowed years 1 to 9999", text));
  const auto datetime = py::module_::import("datetime");
  const auto at_the_minute =
      datetime.attr("datetime")(year, month, day, hour, minute, py::arg("tzinfo") = utc());
  return at_the_minute +
         datetime.attr("timedelta")(py::arg("seconds") = second,  // may be 60 in a leap second
                                    py::arg("milliseconds") = millisecond);
}

almanac::Observer observer_of(py::handle place) {
  if (py::isinstance<py::str>(place)) {
    const auto name = place.cast<std::string>();
    const auto observer = uses::observer_from(name);
    const auto taken = almanac::city_taken(name);
    if (!taken.empty() && PyErr_WarnEx(PyExc_UserWarning, taken.c_str(), 1) != 0)
      throw py::error_already_set();
    return observer;
  }
  const auto numbers = numbers_of("place", place);
  if (numbers.size() < 2 || numbers.size() > 3)
    throw algebra::Error(fmt::format(
        "place of {} numbers, allowed (latitude, longitude) or (latitude, longitude, elevation) in "
        "degrees and metres",
        numbers.size()));
  const almanac::Observer observer{algebra::degrees(numbers[0]), algebra::degrees(numbers[1]),
                                   algebra::metres(numbers.size() == 3 ? numbers[2] : 0)};
  almanac::require_on_earth(observer);
  return observer;
}

std::vector<double> numbers_of(const char* what, py::handle numbers) {
  const auto array = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(
      py::reinterpret_borrow<py::object>(numbers));
  if (!array) {
    PyErr_Clear();
    throw py::type_error(
        fmt::format("{} = {}, allowed numbers", what, py::repr(numbers).cast<std::string>()));
  }
  if (array.ndim() != 1)
    throw algebra::Error(fmt::format("{}: an array of {} axes, allowed 1", what, array.ndim()));
  return {array.data(), array.data() + array.size()};
}

py::object converted(const py::object& array, const py::object& dtype, std::optional<bool> copy) {
  using namespace py::literals;
  const auto own = array.attr("dtype");
  const auto asked = dtype.is_none() ? own : py::module_::import("numpy").attr("dtype")(dtype);
  if (copy == false && !asked.equal(own))
    throw algebra::Error(fmt::format("{} as {} is a copy, allowed copy=None",
                                     py::str(own).cast<std::string>(),
                                     py::str(asked).cast<std::string>()));
  return array.attr("astype")(asked, "copy"_a = copy.value_or(false));
}

}  // namespace coppermoon::python
