// SPDX-License-Identifier: MIT
#include "uses/picture/brightness.h"

#include "almanac/sky.h"
#include "wrappers/python/arguments.h"
#include "wrappers/python/computing.h"
#include "wrappers/python/fields.h"
#include "wrappers/python/nouns.h"
#include "wrappers/python/requests.h"
#include "wrappers/python/results.h"

namespace coppermoon::python {
namespace {

Told<uses::MoonBrightness> brightness_at(const Moment& when, const std::optional<uses::Air>& air,
                                         const std::optional<uses::LightRequest>& light,
                                         const std::optional<Place>& at, const Callback& callback,
                                         const py::kwargs& more) {
  TextureKeywords asked{.moon = {}};
  take_objects(asked, air, light, at);
  take(brightness_keywords(asked), "brightness", more);
  uses::require_map(asked.moon);
  return told(computed(callback, [&](const algebra::Progress& progress) {
    const auto sky = almanac::sky_at(when.seen_from(asked.view.observer));
    return uses::brightness_of(asked.moon, sky, asked.view, progress);
  }));
}

/// The columns of a light curve as arrays by name, with the moments in UTC.
py::dict light_curve(const Moment& first, const Moment& last, double step_min,
                     const std::optional<uses::Air>& air,
                     const std::optional<uses::LightRequest>& light, const std::optional<Place>& at,
                     const Callback& callback, const py::kwargs& more) {
  TextureKeywords asked{.moon = {}};
  take_objects(asked, air, light, at);
  take(brightness_keywords(asked), "light_curve", more);
  uses::require_map(asked.moon);
  const auto curve = computed(callback, [&](const algebra::Progress& progress) {
    const auto& place = asked.view.observer;
    const auto moments =
        uses::moments_between(first.seen_from(place), last.seen_from(place), step_min);
    return uses::light_curve(asked.moon, moments, asked.view, progress);
  });
  py::list instants;
  for (const auto& moment : curve.moments) {
    const auto text = almanac::utc_text(moment.brightness.instant, 3);
    instants.append(text.substr(0, text.find('Z')));
  }
  py::dict columns;
  columns["instant"] = py::array(instants).attr("astype")("datetime64[ms]");
  for (const auto& [name, numbers] : curve.columns) columns[py::str(name)] = array_of(numbers);
  return columns;
}

}  // namespace

void add_brightness(py::module_& package) {
  using namespace py::literals;
  add_result<uses::BrightnessSeen>(package);
  add_result<uses::MoonBrightness>(package);
  TextureKeywords keywords{.moon = {}};
  const auto parameters = brightness_keywords(keywords);
  const auto doc = fmt::format(
      R"(brightness(when, *, air=None, light=None, at=None, {}, progress=None)

Magnitudes, luminance and illuminance of the whole Moon at a moment of an eclipse.

at: place that sees it, through its air: a city, or (latitude, longitude) in degrees
{}progress: called with the fraction that is done, some times a second

>>> full = coppermoon.brightness('2018-07-27T20:21:45Z', unshadowed=True)
>>> sorted(full.magnitudes), 0.1 < full.illuminance_lx < 0.4
(['B', 'R', 'V'], True)
)",
      signature_of(parameters), lines_of(parameters));
  package.def("brightness", brightness_at, "when"_a, py::kw_only(), "air"_a = py::none(),
              "light"_a = py::none(), "at"_a = py::none(), "progress"_a = py::none(), doc.c_str());
  auto columns = result::fields_of<uses::CurveMoment>();
  std::erase_if(columns.all,
                [](const result::Field& each) { return each.kind != result::Kind::number; });
  const auto over_time = fmt::format(
      R"(light_curve(first, last, *, step_min=5.0, air=None, light=None, at=None, {}, progress=None)

The whole Moon over time, from one simulation: a dict of arrays, one number a moment.

instant is NumPy's datetime64 in UTC; what follows altitude_deg is there with a place alone. NaN: not known, or the
Moon is not up.

{}

first, last: moments of one eclipse, at most a day apart
step_min: minutes between the moments, 0.01 to 1440
at: place that sees it, through its air: a city, or (latitude, longitude) in degrees
{}progress: called with the fraction that is done, some times a second

>>> full = coppermoon.light_curve('2018-07-27 P1', '2018-07-27 P4', step_min=60, unshadowed=True)
>>> full['V_magnitude'].shape
(7,)
)",
      signature_of(parameters), lines_of(columns), lines_of(parameters));
  package.def("light_curve", light_curve, "first"_a, "last"_a, py::kw_only(), "step_min"_a = 5.,
              "air"_a = py::none(), "light"_a = py::none(), "at"_a = py::none(),
              "progress"_a = py::none(), over_time.c_str());
}

}  // namespace coppermoon::python
