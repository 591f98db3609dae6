// SPDX-License-Identifier: MIT
#include "wrappers/python/nouns.h"
#include "wrappers/python/own_results.h"
#include "wrappers/python/results.h"

namespace coppermoon::python {
namespace {

Told<SkyOfArrays> sky_of(const Moment& when, const std::optional<Place>& at) {
  const auto seen = [&] {
    const py::gil_scoped_release others_run;
    const auto observer = at ? std::optional(at->observer) : std::nullopt;
    SkyOfArrays sky{{almanac::sky_at(when.seen_from(observer)), {}}};
    if (observer) sky.view = almanac::view_from(*observer, sky.sky);
    return sky;
  }();
  return told(seen);
}

}  // namespace

void add_sky(py::module_& package) {
  using namespace py::literals;
  add_result<SkyOfArrays>(package);
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
