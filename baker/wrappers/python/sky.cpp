// SPDX-License-Identifier: MIT
#include "almanac/sky.h"

#include <glm/geometric.hpp>
#include <optional>

#include "eclipse/shadow_axis.h"
#include "wrappers/python/arguments.h"
#include "wrappers/python/nouns.h"

namespace coppermoon::python {
namespace {

using algebra::in_degrees, algebra::in_kilometres;

/// The sky of a moment, and what a place sees of the Moon.
struct Sky {
  almanac::SkyState state;
  almanac::EquatorialPlace moon;
  eclipse::ShadowPlace in_shadow;
  std::optional<almanac::ObserverView> view;
};

Sky sky_of(const Moment& when, const std::optional<Place>& at) {
  const py::gil_scoped_release others_run;
  const auto state = almanac::sky_at(when.instant);
  Sky sky{state,
          almanac::equatorial_place(state, state.moon_m),
          eclipse::place_in_shadow(eclipse::shadow_axis(state), state.moon_m),
          {}};
  if (at) sky.view = almanac::view_from(at->observer, state);
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

/// What a place sees, or None.
template <class Read>
auto seen(Read read) {
  return [read](const Sky& sky) -> std::optional<double> {
    if (!sky.view) return std::nullopt;
    return read(*sky.view);
  };
}

void add_places(py::class_<Sky>& sky) {
  const auto add = [&](const char* name, auto read, const char* text) {
    sky.def_property_readonly(name, read, text);
  };
  add(
      "moon_ra_deg", [](const Sky& s) { return in_degrees(s.moon.right_ascension); },
      "apparent right ascension of the Moon, of date [degrees]");
  add(
      "moon_dec_deg", [](const Sky& s) { return in_degrees(s.moon.declination); },
      "apparent declination of the Moon, of date [degrees]");
  add(
      "moon_distance_km", [](const Sky& s) { return in_kilometres(s.moon.distance); },
      "distance of the Moon from the Earth's centre [km]");
  add(
      "sun_distance_au",
      [](const Sky& s) { return glm::length(s.state.sun_m) / almanac::astronomical_unit_m; },
      "distance of the Sun [au]");
  add(
      "sub_earth_latitude_deg", [](const Sky& s) { return in_degrees(s.state.sub_earth.latitude); },
      "latitude of the place on the Moon under the Earth: libration [degrees]");
  add(
      "sub_earth_longitude_deg",
      [](const Sky& s) { return in_degrees(s.state.sub_earth.longitude); },
      "longitude of the place on the Moon under the Earth: libration [degrees]");
  add(
      "sub_solar_latitude_deg", [](const Sky& s) { return in_degrees(s.state.sub_solar.latitude); },
      "latitude of the place on the Moon under the Sun [degrees]");
  add(
      "sub_solar_longitude_deg",
      [](const Sky& s) { return in_degrees(s.state.sub_solar.longitude); },
      "longitude of the place on the Moon under the Sun [degrees]");
  add(
      "axis_position_angle_deg",
      [](const Sky& s) { return in_degrees(s.state.axis_position_angle); },
      "position angle of the Moon's north pole, from north through east [degrees]");
  add(
      "axis_distance_km", [](const Sky& s) { return in_kilometres(s.in_shadow.axis_distance); },
      "distance of the Moon's centre from the axis of the Earth's shadow [km]");
  add(
      "sun_m", [](const Sky& s) { return vector_of(s.state.sun_m); },
      "apparent place of the Sun, geocentric, GCRS axes [m], shape (3,)");
  add(
      "moon_m", [](const Sky& s) { return vector_of(s.state.moon_m); },
      "apparent place of the Moon, geocentric, GCRS axes [m], shape (3,)");
  add(
      "selenographic_from_gcrs",
      [](const Sky& s) { return matrix_of(s.state.selenographic_from_gcrs); },
      "matrix from GCRS axes to the Moon's: X to longitude 0, Z north, shape (3, 3)");
}

void add_view(py::class_<Sky>& sky) {
  const auto add = [&](const char* name, auto read, const char* text) {
    sky.def_property_readonly(name, seen(read), text);
  };
  using View = almanac::ObserverView;
  add(
      "altitude_deg", [](const View& v) { return in_degrees(v.altitude); },
      "altitude of the Moon's centre at the place, without refraction [degrees], or None");
  add(
      "azimuth_deg", [](const View& v) { return in_degrees(v.azimuth); },
      "azimuth of the Moon's centre, from north through east [degrees], or None");
  add(
      "parallactic_angle_deg", [](const View& v) { return in_degrees(v.parallactic_angle); },
      "angle at the Moon from celestial north to the zenith, through east [degrees], or None");
  add(
      "observer_moon_distance_km", [](const View& v) { return in_kilometres(v.moon_distance); },
      "distance of the Moon's centre from the place [km], or None");
  add(
      "sub_observer_latitude_deg",
      [](const View& v) { return in_degrees(v.sub_observer.latitude); },
      "latitude of the place on the Moon under the observer [degrees], or None");
  add(
      "sub_observer_longitude_deg",
      [](const View& v) { return in_degrees(v.sub_observer.longitude); },
      "longitude of the place on the Moon under the observer [degrees], or None");
}

}  // namespace

void add_sky(py::module_& package) {
  using namespace py::literals;
  py::class_<Sky> sky(package, "Sky",
                      "Sun, Moon and shadow at one moment, and how the Moon is turned.");
  sky.def_property_readonly(
         "when", [](const Sky& s) { return datetime_of(s.state.when); }, "the moment, UTC")
      .def_property_readonly(
          "delta_t_s", [](const Sky& s) { return almanac::delta_t_s(s.state.when); },
          "TT - UT1 [s]")
      .def("__repr__",
           [](const Sky& s) { return fmt::format("<Sky {}>", almanac::utc_text(s.state.when)); });
  add_places(sky);
  add_view(sky);
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
