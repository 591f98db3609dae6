// SPDX-License-Identifier: MIT
#include "uses/light/moonlight.h"

#include <memory>

#include "almanac/sky.h"
#include "eclipse/shadow_axis.h"
#include "uses/light/spectral_bands.h"
#include "wrappers/python/arguments.h"
#include "wrappers/python/computing.h"
#include "wrappers/python/nouns.h"
#include "wrappers/python/requests.h"

namespace coppermoon::python {
namespace {

/// Light on the Moon of one moment, each wavelength by itself.
struct LitSphere {
  almanac::SkyState sky;
  plan::Plan plan;
  double error_found;
  shadow::Lookup ratios;
};

std::shared_ptr<LitSphere> lit_sphere(const Moment& when, const std::optional<uses::Air>& air,
                                      const std::optional<uses::LightRequest>& light,
                                      const Callback& callback) {
  const auto request = light_request(air, light);
  return computed(callback, [&](const algebra::Progress& progress) {
    const auto sky = almanac::sky_at(when.seen_from({}));
    const auto found = uses::light_on_the_moon(request, sky, {}, progress);
    const auto count = static_cast<std::size_t>(found.plan.work.bands);
    shadow::ChannelWeights each(count, count);
    for (std::size_t i = 0; i < count; ++i) each(i, i) = 1;
    return std::make_shared<LitSphere>(
        LitSphere{sky, found.plan, found.error_found, found.in_sums(each, found.range)});
  });
}

using Degrees = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Ratios at places on the ground, one a wavelength.
std::vector<double> read_all(const LitSphere& moon, const Degrees& latitudes,
                             const Degrees& longitudes) {
  const auto axis = eclipse::shadow_axis(moon.sky);
  std::vector<double> all(static_cast<std::size_t>(latitudes.size()) * moon.ratios.channels());
  const double *latitude = latitudes.data(), *longitude = longitudes.data();
  const auto count = static_cast<std::size_t>(latitudes.size());
  for (std::size_t i = 0; i < count; ++i) {
    algebra::require_within("lunar latitude [deg]", latitude[i], -90, 90);
    algebra::require_within("lunar longitude [deg]", longitude[i], -360, 360);
    const auto ground = almanac::selenographic_direction(
        {algebra::degrees(latitude[i]), algebra::degrees(longitude[i])});
    moon.ratios.read(eclipse::place_of_ground(axis, moon.sky, ground),
                     std::span(all).subspan(i * moon.ratios.channels(), moon.ratios.channels()));
  }
  return all;
}

py::array_t<double> ratios_at(const LitSphere& moon, const Degrees& latitudes,
                              const Degrees& longitudes) {
  std::vector<py::ssize_t> shape(latitudes.shape(), latitudes.shape() + latitudes.ndim());
  if (!std::equal(shape.begin(), shape.end(), longitudes.shape(),
                  longitudes.shape() + longitudes.ndim()))
    throw algebra::Error("latitudes and longitudes: arrays of two shapes, allowed one");
  shape.push_back(static_cast<py::ssize_t>(moon.ratios.channels()));
  std::vector<double> all;
  {
    const py::gil_scoped_release others_run;
    all = read_all(moon, latitudes, longitudes);
  }
  return array_of<double>(std::move(all), std::move(shape));
}

}  // namespace

void add_moonlight(py::module_& package) {
  using namespace py::literals;
  py::class_<LitSphere, std::shared_ptr<LitSphere>>(package, "Moonlight",
                                                    "Light that falls on the Moon at one moment.")
      .def_property_readonly(
          "when", [](const LitSphere& m) { return datetime_of(m.sky.when); }, "the moment, UTC")
      .def_property_readonly(
          "wavelengths_nm",
          [](const LitSphere& m) { return array_of(uses::wavelengths_nm(m.plan.work.bands)); },
          "wavelengths that light was computed at [nm], shape (W,)")
      .def_property_readonly(
          "method", [](const LitSphere& m) { return std::string(plan::name(m.plan.work.solver)); },
          "how it was computed, in words")
      .def_readonly("error_found", &LitSphere::error_found,
                    "relative error of luminance that was found, the largest on the disc")
      .def("ratio", ratios_at, "latitude_deg"_a, "longitude_deg"_a,
           R"(ratio(latitude_deg, longitude_deg)

Spectral irradiance on ground that faces the Sun, over that of unobstructed sunlight.

latitude_deg, longitude_deg: places on the Moon [degrees], north and east positive, of one shape
Returned: that shape and one axis more, of wavelengths)")
      .def("__repr__", [](const LitSphere& m) {
        return fmt::format("<Moonlight {}>", almanac::utc_text(m.sky.when));
      });
  package.def("moonlight", lit_sphere, "when"_a, py::kw_only(), "air"_a = py::none(),
              "light"_a = py::none(), "progress"_a = py::none(),
              R"(moonlight(when, *, air=None, light=None, progress=None)

Light that falls on the Moon at a moment of an eclipse, planned and computed.

progress: called with the fraction that is done, some times a second

>>> draft = coppermoon.Light(bands=4, rays=60)
>>> light = coppermoon.moonlight('2018-07-27T20:21:45Z', air=coppermoon.Air(atmosphere='clear'), light=draft)
>>> light.ratio([0, 60], [0, 30]).shape
(2, 4)
)");
}

}  // namespace coppermoon::python
