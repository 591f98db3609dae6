// SPDX-License-Identifier: MIT
#include "uses/dome/dome.h"

#include "almanac/sky.h"
#include "eclipse/contacts.h"
#include "wrappers/python/computing.h"
#include "wrappers/python/fields.h"
#include "wrappers/python/nouns.h"
#include "wrappers/python/requests.h"
#include "wrappers/python/results.h"

namespace coppermoon::python {
namespace {

/// A dome as its Python object stores it: a dictionary of values by name.
struct Dome {
  py::dict values;
};

result::Fields fields_of_dome() {
  return {
      "Dome",
      "The night sky in all directions: row 0 at the zenith, the horizon in the middle, north in "
      "the middle column, east to the right of it.",
      {{.key = "pixels",
        .unit = "cd/m²",
        .meaning = "scene-linear values, float32, shape (height, width, 3)"},
       {.key = "space", .meaning = "colour space: 'lin_rec709', 'acescg' or 'lin_ciexyzd65_scene'"},
       {.key = "header",
        .meaning = "header of its file, by name; 'coppermoon:recipe' makes the dome again"},
       {.key = "figures",
        .meaning = "luminance, illuminances and places, by name with their units"}}};
}

Dome dome_at(const Moment& when, const Place& at, const std::optional<uses::Air>& air,
             const std::optional<uses::LightRequest>& light, const Callback& callback,
             const py::kwargs& more) {
  DomeKeywords asked;
  auto& moon = asked.moon.moon;
  take_objects(asked.moon, air, light, at);
  take(dome_keywords(asked), "dome", more);
  uses::require_sound(asked.dome);
  moon.texture_width = 720;  // enough for the Moon's total light
  auto dome = computed(callback, [&](const algebra::Progress& progress) {
    const auto sky = almanac::sky_at(when.seen_from(asked.moon.view.observer));
    if (!eclipse::eclipse_at(sky.when, eclipse::ShadowConvention::danjon)) moon.unshadowed = true;
    return uses::dome_over(asked.dome, uses::lit_moon(moon, sky, progress), asked.moon.view);
  });
  const std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(dome.light.height),
                                       static_cast<py::ssize_t>(dome.light.width), 3};
  py::dict figures;
  describe(Keeps{figures}, dome.figures);
  Dome made;
  made.values["pixels"] = array_of<float>(std::move(dome.light.values), shape);
  made.values["space"] = std::string(colour::name(space_of(asked.dome.content)));
  made.values["header"] = header_of(dome.attributes);
  made.values["figures"] = figures;
  return made;
}

}  // namespace

void add_dome(py::module_& package) {
  using namespace py::literals;
  auto dome = add_kept<Dome>(package, fields_of_dome());
  add_array_protocol(dome, "pixels");
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
