// SPDX-License-Identifier: MIT
#include "eclipse/contacts.h"

#include <algorithm>

#include "wrappers/python/computing.h"
#include "wrappers/python/nouns.h"
#include "wrappers/python/results.h"

namespace coppermoon::python {
namespace {

using eclipse::Eclipse, eclipse::ShadowConvention;

/// Searches for eclipses a few years at a time, so that the search can be interrupted in between.
py::list eclipses_in(const Date& start, const Date& stop, ShadowConvention convention,
                     const Callback& callback) {
  constexpr double at_a_time_s = 2e8;
  return kept(computed(callback, [&](const algebra::Progress& progress) {
    std::vector<Eclipse> all;
    const double length_s = almanac::seconds_between(start.instant, stop.instant);
    if (!(length_s >= 0))
      throw algebra::Error(fmt::format("stop = {}, allowed {} or later",
                                       almanac::utc_text(stop.instant),
                                       almanac::utc_text(start.instant)));
    for (double from_s = 0; from_s <= length_s; from_s += at_a_time_s) {
      const auto from = almanac::later(start.instant, from_s),
                 to = almanac::later(start.instant, std::min(from_s + at_a_time_s, length_s));
      for (const auto& each : eclipse::eclipses_between(from, to, convention)) all.push_back(each);
      progress(std::min(1., (from_s + at_a_time_s) / std::max(1., length_s)));
    }
    return all;
  }));
}

Told<Eclipse> nearest(const Date& when, ShadowConvention convention) {
  return told([&] {
    const py::gil_scoped_release others_run;
    return eclipse::nearest_eclipse(when.instant, convention);
  }());
}

}  // namespace

void add_eclipses(py::module_& package) {
  using namespace py::literals;
  add_result<Eclipse>(package);
  package.def("eclipses", eclipses_in, "start"_a, "stop"_a, py::kw_only(),
              "convention"_a = ShadowConvention::danjon, "progress"_a = py::none(),
              R"(eclipses(start, stop, *, convention='danjon', progress=None)

The eclipses whose greatest phase lies between two moments, in their order. A day alone begins at its midnight, UTC.

convention: how the air enlarges the shadow. Times are right to 8 s at worst from 1951 to 2025. A datetime knows the
years 1 to 9999; contacts of other years raise an Error.

>>> [str(e.greatest.date()) for e in coppermoon.eclipses('2018-01-01', '2019-01-01')]
['2018-01-31', '2018-07-27']
)");
  package.def("nearest_eclipse", nearest, "when"_a, py::kw_only(),
              "convention"_a = ShadowConvention::danjon,
              R"(nearest_eclipse(when, *, convention='danjon')

The eclipse whose greatest phase is nearest in time, before or after. A day alone is its midnight, UTC.

>>> eclipse = coppermoon.nearest_eclipse('2018-07-27')
>>> eclipse.type, round(eclipse.umbral_magnitude, 2)
('total', 1.61)
>>> str(eclipse.contacts['U2'].replace(microsecond=0))
'2018-07-27 19:30:16+00:00'
)");
}

}  // namespace coppermoon::python
