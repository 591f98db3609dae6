// SPDX-License-Identifier: MIT
#include "uses/picture/brightness.h"

#include "almanac/sky.h"
#include "uses/light/photometric_bands.h"
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
}

}  // namespace coppermoon::python
