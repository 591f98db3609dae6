// SPDX-License-Identifier: MIT
#include "uses/picture/brightness.h"

#include "almanac/sky.h"
#include "uses/light/photometer.h"
#include "wrappers/python/arguments.h"
#include "wrappers/python/computing.h"
#include "wrappers/python/fields.h"
#include "wrappers/python/nouns.h"
#include "wrappers/python/requests.h"

namespace coppermoon::python {
namespace {

py::dict by_band(const std::vector<double>& numbers) {
  const auto bands = uses::photometric_bands();
  py::dict all;
  for (std::size_t k = 0; k < bands.size(); ++k) all[py::str(bands[k].name)] = numbers[k];
  return all;
}

uses::MoonBrightness brightness_at(const Moment& when, const std::optional<uses::Air>& air,
                                   const std::optional<uses::LightRequest>& light,
                                   const std::optional<Place>& at, const Callback& callback,
                                   const py::kwargs& more) {
  TextureKeywords asked{.moon = {}};
  take_objects(asked, air, light, at);
  take(brightness_keywords(asked), "brightness", more);
  uses::require_map(asked.moon);
  return computed(callback, [&](const algebra::Progress& progress) {
    const auto sky = almanac::sky_at(when.seen_from(asked.view.observer));
    return uses::brightness_of(asked.moon, sky, asked.view, progress);
  });
}

/// Columns of a light curve as arrays, the moments in UTC.
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
  for (const auto& when : curve.moments) {
    const auto text = almanac::utc_text(when, 3);
    instants.append(text.substr(0, text.find('Z')));
  }
  py::dict columns;
  columns["instant"] = py::array(instants).attr("astype")("datetime64[ms]");
  for (const auto& [name, numbers] : curve.columns)
    columns[py::str(name)] = py::array_t<double>(numbers.size(), numbers.data());
  return columns;
}

/// Properties of the whole Moon, which both classes have.
template <class Class>
void add_disc(Class& brightness) {
  using Bright = typename Class::type;
  brightness
      .def_property_readonly(
          "magnitudes", [](const Bright& b) { return by_band(b.disc.magnitudes); },
          "magnitudes of the whole Moon by band: B and V (Johnson), R (Cousins)")
      .def_property_readonly(
          "mean_luminance_cd_m2", [](const Bright& b) { return b.disc.mean_luminance_cd_m2; },
          "luminance, the mean over the disc [cd/m²]")
      .def_property_readonly(
          "illuminance_lx", [](const Bright& b) { return b.disc.illuminance_lx; },
          "illuminance on a surface that faces the Moon [lx]");
}

}  // namespace

void add_brightness(py::module_& package) {
  using namespace py::literals;
  using Seen = uses::BrightnessSeen;
  using Brightness = uses::MoonBrightness;
  py::class_<Seen> seen(package, "BrightnessSeen",
                        "The whole Moon as a place on the Earth sees it, through its air.");
  add_disc(seen);
  seen.def_property_readonly(
          "altitude_deg", [](const Seen& s) { return algebra::in_degrees(s.moon.altitude); },
          "altitude of the Moon, refraction counted [degrees]")
      .def_property_readonly(
          "azimuth_deg", [](const Seen& s) { return algebra::in_degrees(s.moon.azimuth); },
          "azimuth of the Moon, from north through east [degrees]")
      .def_property_readonly(
          "extinction_mag", [](const Seen& s) { return by_band(s.extinction_mag); },
          "magnitudes by which the air dims the Moon, by band");
  py::class_<Brightness> brightness(package, "Brightness",
                                    "The whole Moon, above the air and from the Earth's centre.");
  add_disc(brightness);
  brightness
      .def_readonly("danjon", &Brightness::danjon,
                    "step of Danjon's scale, 0 to 4, in totality; else None")
      .def_readonly(
          "V_error", &Brightness::V_error,
          "standard error of the V magnitude, in totality and the air of a month; else None")
      .def_readonly("seen", &Brightness::seen, "what a place sees, or None");
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
  const auto over_time = fmt::format(
      R"(light_curve(first, last, *, step_min=5.0, air=None, light=None, at=None, {}, progress=None)

The whole Moon over time, from one simulation: a dict of arrays, one number a moment.

instant is NumPy's datetime64 in UTC; B_magnitude, V_magnitude, R_magnitude, mean_luminance_cd_m2,
illuminance_lx and V_error are above the air. With a place also altitude_deg, azimuth_deg, sky_cd_m2 (the
clear sky around the Moon), and, through its air, seen_B_magnitude and so on, seen_illuminance_lx,
seen_level_illuminance_lx (on level ground). NaN: not known, or the Moon is not up.

first, last: moments of one eclipse, at most a day apart
step_min: minutes between the moments, 0.01 to 1440
at: place that sees it, through its air: a city, or (latitude, longitude) in degrees
{}progress: called with the fraction that is done, some times a second

>>> full = coppermoon.light_curve('2018-07-27 P1', '2018-07-27 P4', step_min=60, unshadowed=True)
>>> full['V_magnitude'].shape
(7,)
)",
      signature_of(parameters), lines_of(parameters));
  package.def("light_curve", light_curve, "first"_a, "last"_a, py::kw_only(), "step_min"_a = 5.,
              "air"_a = py::none(), "light"_a = py::none(), "at"_a = py::none(),
              "progress"_a = py::none(), over_time.c_str());
}

}  // namespace coppermoon::python
