// SPDX-License-Identifier: MIT
#include "eclipse/sky_columns.h"

#include <optional>
#include <string>

#include "wrappers/python/arguments.h"
#include "wrappers/python/nouns.h"

namespace coppermoon::python {
namespace {

/// Sky of a moment, and the Moon as a place sees it.
struct Sky {
  almanac::SkyState state;
  std::optional<almanac::ObserverView> view;
};

Sky sky_of(const Moment& when, const std::optional<Place>& at) {
  const py::gil_scoped_release others_run;
  const auto observer = at ? std::optional(at->observer) : std::nullopt;
  Sky sky{almanac::sky_at(when.seen_from(observer)), {}};
  if (observer) sky.view = almanac::view_from(*observer, sky.state);
  return sky;
}

py::array_t<double> vector_of(const glm::dvec3& v) {
  return array_of(std::vector<double>{v.x, v.y, v.z});
}

py::array_t<double> matrix_of(const glm::dmat3& m) {
  algebra::Grid<double> grid(3, 3);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      grid(static_cast<std::size_t>(row), static_cast<std::size_t>(column)) = m[column][row];
  return array_of(std::move(grid));
}

void add_numbers(py::class_<Sky>& sky) {
  for (const auto& column : eclipse::sky_columns())
    sky.def_property_readonly(
        column.name, [&column](const Sky& s) { return column.value(s.state); }, column.text);
  for (const auto& column : eclipse::view_columns())
    sky.def_property_readonly(
        column.name,
        [&column](const Sky& s) {
          return s.view ? std::optional(column.value(*s.view)) : std::nullopt;
        },
        (std::string(column.text) + ", or None").c_str());
}

}  // namespace

void add_sky(py::module_& package) {
  using namespace py::literals;
  py::class_<Sky> sky(package, "Sky",
                      "Sun, Moon and shadow at one moment, and how the Moon is turned.");
  sky.def_property_readonly(
         "when", [](const Sky& s) { return datetime_of(s.state.when); }, "the moment, UTC")
      .def_property_readonly(
          "sun_m", [](const Sky& s) { return vector_of(s.state.sun_m); },
          "apparent place of the Sun, geocentric, GCRS axes [m], shape (3,)")
      .def_property_readonly(
          "moon_m", [](const Sky& s) { return vector_of(s.state.moon_m); },
          "apparent place of the Moon, geocentric, GCRS axes [m], shape (3,)")
      .def_property_readonly(
          "selenographic_from_gcrs",
          [](const Sky& s) { return matrix_of(s.state.selenographic_from_gcrs); },
          "matrix from GCRS axes to the Moon's: X to longitude 0, Z north, shape (3, 3)")
      .def("__repr__",
           [](const Sky& s) { return fmt::format("<Sky {}>", almanac::utc_text(s.state.when)); });
  add_numbers(sky);
  package.def("sky", sky_of, "when"_a, "at"_a = py::none(),
              R"(sky(when, at=None)

Where Sun, Moon and shadow are at a moment, and how the Moon is turned; with a place, what it sees too.

at: name of a city, or (latitude, longitude) or (latitude, longitude, elevation) in degrees and metres.

>>> sky = coppermoon.sky('2018-07-27T20:21:45Z', at='Nairobi')
>>> round(sky.axis_distance_km), round(sky.altitude_deg)
(745, 64)
)");
}

}  // namespace coppermoon::python
