// SPDX-License-Identifier: MIT
#include "uses/dome/dome.h"

#include "almanac/sky.h"
#include "eclipse/contacts.h"
#include "wrappers/python/arguments.h"
#include "wrappers/python/computing.h"
#include "wrappers/python/fields.h"
#include "wrappers/python/nouns.h"
#include "wrappers/python/requests.h"

namespace coppermoon::python {
namespace {

/// A dome as arrays.
struct DomeArrays {
  py::object pixels;
  std::string space;
  py::dict header, figures;
};

DomeArrays dome_at(const Moment& when, const Place& at, const std::optional<uses::Air>& air,
                   const std::optional<uses::LightRequest>& light, const Callback& callback,
                   const py::kwargs& more) {
  DomeKeywords asked;
  auto& moon = asked.moon.moon;
  take_objects(asked.moon, air, light, at);
  take(dome_keywords(asked), "dome", more);
  uses::require_sound(asked.dome);
  uses::require_map(moon);
  moon.texture_width = 720;  // of the Moon's whole light
  auto dome = computed(callback, [&](const algebra::Progress& progress) {
    const auto sky = almanac::sky_at(when.seen_from(asked.moon.view.observer));
    if (!eclipse::eclipse_at(sky.when, eclipse::ShadowConvention::danjon)) moon.unshadowed = true;
    return uses::dome_over(asked.dome, uses::lit_moon(moon, sky, progress), asked.moon.view);
  });
  const std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(dome.light.height),
                                       static_cast<py::ssize_t>(dome.light.width), 3};
  DomeArrays arrays{array_of<float>(std::move(dome.light.values), shape),
                    std::string(colour::name(space_of(asked.dome.content))),
                    {},
                    {}};
  for (const auto& [name, value] : dome.attributes) arrays.header[py::str(name)] = value;
  for (const auto& [name, value] : dome.figures) arrays.figures[py::str(name)] = value;
  return arrays;
}

}  // namespace

void add_dome(py::module_& package) {
  using namespace py::literals;
  py::class_<DomeArrays>(package, "Dome",
                         "The night sky in all directions: row 0 at the zenith, the horizon in the "
                         "middle, north in the middle column, east to the right of it.")
      .def_readonly("pixels", &DomeArrays::pixels,
                    "scene-linear values [cd/m²], float32, shape (height, width, 3)")
      .def_readonly("space", &DomeArrays::space,
                    "colour space: 'lin_rec709', 'acescg' or 'lin_ciexyzd65_scene'")
      .def_readonly("header", &DomeArrays::header,
                    "header of its file, by name; 'coppermoon:recipe' makes the dome again")
      .def_readonly("figures", &DomeArrays::figures,
                    "luminance, illuminances and places, by name with their units")
      .def(
          "__array__",
          [](const DomeArrays& dome, const py::object& dtype, std::optional<bool> copy) {
            return converted(dome.pixels, dtype, copy);
          },
          "dtype"_a = py::none(), "copy"_a = py::none())
      .def("__repr__", [](const DomeArrays& dome) {
        return fmt::format("<Dome {} of shape {}>", dome.space,
                           py::str(dome.pixels.attr("shape")).cast<std::string>());
      });
  DomeKeywords keywords;
  const auto parameters = dome_keywords(keywords);
  const auto doc = fmt::format(
      R"(dome(when, *, at, air=None, light=None, {}, progress=None)

The night sky around the Moon at a moment and a place: luminances of a scene-linear colour space [cd/m²].

at: place under the sky: a city, or (latitude, longitude) in degrees
{}progress: called with the fraction that is done, some times a second

>>> sky = coppermoon.dome('2018-07-27T20:21:45Z', at='Nairobi', width=32, unshadowed=True)
>>> sky.pixels.shape, 0.001 < sky.figures['zenith_luminance_cd_m2'] < 0.02
((16, 32, 3), True)
)",
      signature_of(parameters), lines_of(parameters));
  package.def("dome", dome_at, "when"_a, py::kw_only(), "at"_a, "air"_a = py::none(),
              "light"_a = py::none(), "progress"_a = py::none(), doc.c_str());
}

}  // namespace coppermoon::python
