// SPDX-License-Identifier: MIT
// What Python's arguments become: moments, places, words, arrays. Whatever takes or gives one of them includes this.
#pragma once

#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "algebra/error.h"
#include "algebra/grid.h"
#include "almanac/instant.h"
#include "almanac/observer.h"
#include "atmosphere/atmosphere.h"
#include "eclipse/contacts.h"
#include "shadow/by_photons.h"
#include "surface/photometry.h"
#include "texture/read_image.h"
#include "uses/light/moonlight.h"
#include "uses/picture/moon.h"

namespace coppermoon::python {

namespace py = pybind11;

/// A moment as Python tells it: a datetime with a time zone, an ISO 8601 text, or a day and a contact.
struct Moment {
  almanac::Instant instant;
};

/// A place on the Earth: the name of a city, or latitude, longitude and elevation [degrees, m].
struct Place {
  almanac::Observer observer;
};

/// Throws  Error       when it is no such moment; datetimes without a time zone are none
///         type_error  when it is neither a datetime nor a text
almanac::Instant instant_of(py::handle moment);

/// A datetime in UTC, to the millisecond.
///
/// Throws  Error  outside of the years 1 to 9999, which are all that a datetime knows
py::object datetime_of(const almanac::Instant& instant);

/// Throws  Error  when no city has that name, or a number is outside its range
almanac::Observer observer_of(py::handle place);

/// Numbers along one axis.
///
/// Throws  Error       when they have more axes or none
///         type_error  when they are no numbers
std::vector<double> numbers_of(const char* what, py::handle numbers);

/// The words that stand for the values of an enumeration: those of the command's options.
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
struct Words<uses::EarthFigure> {
  static constexpr std::string_view what = "earth";
  static constexpr std::array all{std::pair{"sphere", uses::EarthFigure::sphere},
                                  std::pair{"ellipsoid", uses::EarthFigure::ellipsoid}};
};

template <>
struct Words<atmosphere::Density> {
  static constexpr std::string_view what = "density";
  static constexpr std::array all{std::pair{"seasonal", atmosphere::Density::seasonal},
                                  std::pair{"us-1976", atmosphere::Density::us_1976},
                                  std::pair{"yapo-cutler", atmosphere::Density::yapo_cutler}};
};

template <>
struct Words<atmosphere::Dispersion> {
  static constexpr std::string_view what = "dispersion";
  static constexpr std::array all{std::pair{"ciddor", atmosphere::Dispersion::ciddor_1996},
                                  std::pair{"crc", atmosphere::Dispersion::crc}};
};

template <>
struct Words<atmosphere::KingFactor> {
  static constexpr std::string_view what = "king_factor";
  static constexpr std::array all{std::pair{"bates", atmosphere::KingFactor::bates_1984},
                                  std::pair{"fixed", atmosphere::KingFactor::fixed}};
};

template <>
struct Words<atmosphere::OzonePath> {
  static constexpr std::string_view what = "ozone_path";
  static constexpr std::array all{std::pair{"bent", atmosphere::OzonePath::bent},
                                  std::pair{"filter", atmosphere::OzonePath::filter}};
};

template <>
struct Words<uses::OzoneProfile> {
  static constexpr std::string_view what = "ozone_profile";
  static constexpr std::array all{std::pair{"climatology", uses::OzoneProfile::climatology},
                                  std::pair{"us-1976", uses::OzoneProfile::us_1976}};
};

template <>
struct Words<atmosphere::StratosphericAerosol> {
  static constexpr std::string_view what = "stratospheric_aerosol";
  static constexpr std::array all{
      std::pair{"none", atmosphere::StratosphericAerosol::none},
      std::pair{"background", atmosphere::StratosphericAerosol::background},
      std::pair{"moderate", atmosphere::StratosphericAerosol::moderate},
      std::pair{"high", atmosphere::StratosphericAerosol::high},
      std::pair{"extreme", atmosphere::StratosphericAerosol::extreme}};
};

template <>
struct Words<uses::ScatteredLight> {
  static constexpr std::string_view what = "scattered_light";
  static constexpr std::array all{std::pair{"auto", uses::ScatteredLight::automatic},
                                  std::pair{"on", uses::ScatteredLight::on},
                                  std::pair{"off", uses::ScatteredLight::off}};
};

template <>
struct Words<uses::Solver> {
  static constexpr std::string_view what = "solver";
  static constexpr std::array all{std::pair{"auto", uses::Solver::automatic},
                                  std::pair{"quadrature", uses::Solver::quadrature},
                                  std::pair{"photons", uses::Solver::photons}};
};

template <>
struct Words<shadow::Trace> {
  static constexpr std::string_view what = "trace";
  static constexpr std::array all{std::pair{"table", shadow::Trace::table},
                                  std::pair{"marched", shadow::Trace::marched},
                                  std::pair{"each", shadow::Trace::step_by_step}};
};

template <>
struct Words<photons::Precision> {
  static constexpr std::string_view what = "precision";
  static constexpr std::array all{std::pair{"full", photons::Precision::full},
                                  std::pair{"single", photons::Precision::single}};
};

template <>
struct Words<surface::Photometry> {
  static constexpr std::string_view what = "photometry";
  static constexpr std::array all{
      std::pair{"lommel-seeliger-rolo", surface::Photometry::lommel_seeliger_rolo},
      std::pair{"yapo-cutler", surface::Photometry::yapo_cutler}};
};

template <>
struct Words<texture::Coding> {
  static constexpr std::string_view what = "coding";
  static constexpr std::array all{std::pair{"as-file-says", texture::Coding::as_file_says},
                                  std::pair{"srgb", texture::Coding::srgb},
                                  std::pair{"linear", texture::Coding::linear},
                                  std::pair{"camera", texture::Coding::camera}};
};

template <>
struct Words<uses::AlbedoEncoding> {
  static constexpr std::string_view what = "albedo_encoding";
  static constexpr std::array all{
      std::pair{"image", uses::AlbedoEncoding::image},
      std::pair{"normal-albedo", uses::AlbedoEncoding::normal_albedo},
      std::pair{"cgi-moon-kit-2019", uses::AlbedoEncoding::cgi_moon_kit_2019},
      std::pair{"cgi-moon-kit-2025", uses::AlbedoEncoding::cgi_moon_kit_2025}};
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
  PYBIND11_TYPE_CASTER(coppermoon::python::Moment, const_name("datetime | str"));
  bool load(handle source, bool) {
    value = {coppermoon::python::instant_of(source)};
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
