// SPDX-License-Identifier: MIT
#include "uses/light/shadow_profile.h"

#include "almanac/sky.h"
#include "wrappers/python/arguments.h"
#include "wrappers/python/computing.h"
#include "wrappers/python/nouns.h"
#include "wrappers/python/requests.h"

namespace coppermoon::python {
namespace {

/// The library's profile as arrays.
struct Profile {
  py::array_t<double> wavelengths_nm, axis_distances_km, ratio, standard_error;
};

Profile profile_of(const Moment& when, const py::object& wavelengths_nm,
                   const py::object& axis_distances_km, std::optional<double> position_angle_deg,
                   const std::optional<uses::Air>& air,
                   const std::optional<uses::LightRequest>& light, const Callback& callback) {
  uses::ProfilePlaces places{.position_angle_deg = position_angle_deg};
  places.wavelengths_nm = numbers_of("wavelengths_nm", wavelengths_nm);
  if (!axis_distances_km.is_none()) {
    for (const double km : numbers_of("axis_distances_km", axis_distances_km))
      places.axis_distances_m.push_back(km * 1e3);
    if (places.axis_distances_m.empty())
      throw algebra::Error("axis_distances_km: no number, allowed 1 or more, or None");
  }
  const auto request = light_request(air, light);
  auto found = computed(callback, [&](const algebra::Progress& progress) {
    const auto sky = almanac::sky_at(when.seen_from({}));
    auto profile =
        uses::shadow_profile(request, uses::shadow_at_the_moon(request, sky), places, progress);
    for (double& metres : profile.axis_distances_m) metres /= 1e3;
    return profile;
  });
  return {array_of(std::move(found.wavelengths_nm)), array_of(std::move(found.axis_distances_m)),
          array_of(std::move(found.ratio)), array_of(std::move(found.standard_error))};
}

}  // namespace

void add_shadow(py::module_& package) {
  using namespace py::literals;
  py::class_<Profile>(package, "ShadowProfile",
                      "Light across the Earth's shadow, over unobstructed sunlight.")
      .def_readonly("wavelengths_nm", &Profile::wavelengths_nm, "wavelengths [nm], shape (W,)")
      .def_readonly("axis_distances_km", &Profile::axis_distances_km,
                    "distances from the shadow's axis [km], shape (D,)")
      .def_readonly("ratio", &Profile::ratio,
                    "spectral irradiance over that of unobstructed sunlight, shape (D, W)")
      .def_readonly("standard_error", &Profile::standard_error,
                    "standard error of the ratio, of photons, shape (D, W)")
      .def("__repr__", [](const Profile& profile) {
        return fmt::format("<ShadowProfile of {} distances, {} wavelengths>",
                           profile.axis_distances_km.size(), profile.wavelengths_nm.size());
      });
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
>>> profile.ratio.shape, bool(profile.ratio[0, 1] > profile.ratio[0, 0])
((2, 2), True)
)");
}

}  // namespace coppermoon::python
