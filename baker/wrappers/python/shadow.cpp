// SPDX-License-Identifier: MIT
#include "uses/light/shadow_profile.h"

#include "almanac/sky.h"
#include "wrappers/python/computing.h"
#include "wrappers/python/nouns.h"
#include "wrappers/python/requests.h"
#include "wrappers/python/results.h"

namespace coppermoon::python {
namespace {

Told<uses::ShadowProfile> profile_of(const Moment& when, const py::object& wavelengths_nm,
                                     const py::object& axis_distances_km,
                                     std::optional<double> position_angle_deg,
                                     const std::optional<uses::Air>& air,
                                     const std::optional<uses::LightRequest>& light,
                                     const Callback& callback) {
  uses::ProfilePlaces places{.position_angle_deg = position_angle_deg};
  places.wavelengths_nm = numbers_of("wavelengths_nm", wavelengths_nm);
  if (!axis_distances_km.is_none()) {
    for (const double km : numbers_of("axis_distances_km", axis_distances_km))
      places.axis_distances_m.push_back(km * 1e3);
    if (places.axis_distances_m.empty())
      throw algebra::Error("axis_distances_km: no number, allowed 1 or more, or None");
  }
  const auto request = light_request(air, light);
  return told(computed(callback, [&](const algebra::Progress& progress) {
    const auto sky = almanac::sky_at(when.seen_from({}));
    return uses::shadow_profile(request, uses::shadow_at_the_moon(request, sky), places, progress);
  }));
}

}  // namespace

void add_shadow(py::module_& package) {
  using namespace py::literals;
  add_result<uses::ShadowProfile>(package);
  package.def(
      "shadow_profile", profile_of, "when"_a, "wavelengths_nm"_a = py::make_tuple(450., 550., 650.),
      "axis_distances_km"_a = py::none(), py::kw_only(), "position_angle_deg"_a = py::none(),
      "air"_a = py::none(), "light"_a = py::none(), "progress"_a = py::none(),
      R"(shadow_profile(when, wavelengths_nm=(450.0, 550.0, 650.0), axis_distances_km=None, *, position_angle_deg=None, air=None, light=None, progress=None)

Irradiance across the Earth's shadow at the Moon's distance, over unobstructed sunlight.

wavelengths_nm: 380 to 780 [nm]
axis_distances_km: distances from the shadow's axis [km], increasing; None: every 100 km, to the shadow's end
position_angle_deg: about the axis, from celestial north through east, 0 to 360; None: the mean over all
progress: called with the fraction that is done, some times a second

>>> clear = coppermoon.Air(atmosphere='clear')
>>> profile = coppermoon.shadow_profile('2018-07-27T20:21:45Z', [550, 650], [0, 4000], air=clear)
>>> profile.irradiance_ratio.shape, bool(profile.irradiance_ratio[0, 1] > profile.irradiance_ratio[0, 0])
((2, 2), True)
)");
}

}  // namespace coppermoon::python
