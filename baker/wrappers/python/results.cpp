// SPDX-License-Identifier: MIT
#include "wrappers/python/results.h"

#include <cmath>

namespace coppermoon::python {
namespace {

bool is_not_a_number(py::handle value) {
  return py::isinstance<py::float_>(value) && std::isnan(value.cast<double>());
}

bool are_equal_arrays(py::handle a, py::handle b) {
  const auto same = [&](const char* what) { return a.attr(what).equal(b.attr(what)); };
  return same("dtype") && same("shape") && a.attr("tobytes")().equal(b.attr("tobytes")());
}

/// A value as text. None becomes an empty string.
std::string text_of(py::handle value) {
  constexpr std::size_t most_shown = 8;
  if (value.is_none()) return "";
  if (py::isinstance<py::array>(value))
    return fmt::format("<array {}>", py::str(value.attr("shape")).cast<std::string>());
  const bool of_dict = py::isinstance<py::dict>(value), of_list = py::isinstance<py::list>(value);
  if (!of_dict && !of_list) return py::repr(value).cast<std::string>();
  if (py::len(value) > most_shown) return fmt::format("<{} values>", py::len(value));
  std::string text;
  for (const auto each : value)
    text += fmt::format(
        "{}{}", text.empty() ? "" : ", ",
        of_dict ? fmt::format("{}: {}", text_of(each), text_of(value[each])) : text_of(each));
  return fmt::format(fmt::runtime(of_dict ? "{{{}}}" : "[{}]"), text);
}

}  // namespace

py::object shown(const result::Field& field, const py::dict& values) {
  auto value = py::reinterpret_borrow<py::object>(values[field.key.c_str()]);
  if (value.is_none()) return value;
  if (field.kind == result::Kind::instant) return datetime_of(value.cast<std::string>());
  if (field.kind != result::Kind::by_name || field.of != result::Kind::instant) return value;
  py::dict all;
  for (const auto& [name, text] : value.cast<py::dict>())
    all[name] = datetime_of(text.cast<std::string>());
  return all;
}

std::string text_of(const std::string& type, const py::dict& values) {
  std::string text;
  for (const auto& [key, value] : values)
    if (const auto told = text_of(value);
        !told.empty() && !key.cast<std::string>().starts_with('_'))
      text += fmt::format("{}{}={}", text.empty() ? "" : ", ", key.cast<std::string>(), told);
  return fmt::format("{}({})", type, text);
}

bool are_equal(py::handle a, py::handle b) {
  if (!py::type::of(a).is(py::type::of(b))) return false;
  if (py::isinstance<py::array>(a)) return are_equal_arrays(a, b);
  if (is_not_a_number(a)) return is_not_a_number(b);
  const bool of_dict = py::isinstance<py::dict>(a);
  if (!of_dict && !py::isinstance<py::list>(a)) return a.equal(b);
  const auto items = [&](py::handle all) {
    return py::list(of_dict ? py::object(all.attr("values")())
                            : py::reinterpret_borrow<py::object>(all));
  };
  const auto left = items(a), right = items(b);
  if (left.size() != right.size()) return false;
  for (std::size_t i = 0; i < left.size(); ++i)
    if (!are_equal(left[i], right[i])) return false;
  return true;
}

}  // namespace coppermoon::python
