// SPDX-License-Identifier: MIT
#include "uses/light/moonlight.h"

#include <memory>
#include <tuple>

#include "almanac/sky.h"
#include "eclipse/shadow_axis.h"
#include "uses/light/spectral_bands.h"
#include "wrappers/python/computing.h"
#include "wrappers/python/nouns.h"
#include "wrappers/python/own_results.h"
#include "wrappers/python/requests.h"
#include "wrappers/python/results.h"

namespace coppermoon::python {
namespace {

/// Table of the ratio of light to unobstructed sunlight. A Python object Moonlight stores it under the key "_ratios".
struct Ratios {
  almanac::SkyState sky;
  shadow::Lookup lookup;
};

py::object stored(const std::vector<double>& numbers) { return array_of(numbers); }
template <class Number>
py::object stored(const Number& number) {
  return py::cast(number);
}
py::object stored(const algebra::Grid<float>& grid) {
  return array_of<float>(algebra::Grid<float>(grid), {static_cast<py::ssize_t>(grid.rows()),
                                                      static_cast<py::ssize_t>(grid.columns())});
}

template <class Number>
void restore(Number& number, py::handle from) {
  number = from.cast<Number>();
}
void restore(algebra::Grid<float>& grid, py::handle from) {
  const auto array = from.cast<py::array_t<float, py::array::c_style>>();
  grid = {static_cast<std::size_t>(array.shape(0)), static_cast<std::size_t>(array.shape(1))};
  std::copy_n(array.data(), array.size(), grid.values().begin());
}

/// References to the members of an instant and a lookup table that are saved and restored by Python's pickle.
template <class Instant, class Table>
auto members(Instant& when, Table& table) {
  return std::tie(when.tt_day, when.tt_fraction, table.channels, table.depths_m,
                  table.middle_depth_m, table.sunlight, table.sectors.around, table.sectors.first,
                  table.sectors.count, table.held, table.nodes.first_m, table.nodes.cell_m,
                  table.nodes.first_node, table.nodes.parts, table.nodes.at_m, table.end_m,
                  table.values);
}

py::list state_of(const Ratios& ratios) {
  py::list state;
  std::apply([&](const auto&... each) { (state.append(stored(each)), ...); },
             members(ratios.sky.when, ratios.lookup.table()));
  return state;
}

std::shared_ptr<Ratios> ratios_from(const py::list& state) {
  almanac::Instant when;
  shadow::LookupTable table;
  std::size_t next = 0;
  std::apply([&](auto&... each) { (restore(each, state[next++]), ...); }, members(when, table));
  return std::make_shared<Ratios>(Ratios{almanac::sky_at(when), shadow::Lookup(std::move(table))});
}

Told<LitSphere> lit_sphere(const Moment& when, const std::optional<uses::Air>& air,
                           const std::optional<uses::LightRequest>& light,
                           const Callback& callback) {
  const auto request = light_request(air, light);
  LitSphere moon;
  const auto ratios = computed(callback, [&](const algebra::Progress& progress) {
    const auto sky = almanac::sky_at(when.seen_from({}));
    const auto found = uses::light_on_the_moon(request, sky, {}, progress);
    const auto count = static_cast<std::size_t>(found.plan.work.bands);
    shadow::ChannelWeights each(count, count);
    for (std::size_t i = 0; i < count; ++i) each(i, i) = 1;
    moon = {sky.when, found.plan.work, found.error_found};
    return std::make_shared<Ratios>(Ratios{sky, found.in_sums(each, found.range)});
  });
  auto made = told(moon);
  made.values["_ratios"] = py::cast(ratios);
  return made;
}

using Degrees = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Ratios of light to unobstructed sunlight, for each place on the Moon and each wavelength.
std::vector<double> read_all(const Ratios& moon, const Degrees& latitudes,
                             const Degrees& longitudes) {
  const auto axis = eclipse::shadow_axis(moon.sky);
  std::vector<double> all(static_cast<std::size_t>(latitudes.size()) * moon.lookup.channels());
  const double *latitude = latitudes.data(), *longitude = longitudes.data();
  const auto count = static_cast<std::size_t>(latitudes.size());
  for (std::size_t i = 0; i < count; ++i) {
    algebra::require_within("lunar latitude [deg]", latitude[i], -90, 90);
    algebra::require_within("lunar longitude [deg]", longitude[i], -360, 360);
    const auto ground = almanac::selenographic_direction(
        {algebra::degrees(latitude[i]), algebra::degrees(longitude[i])});
    moon.lookup.read(eclipse::place_of_ground(axis, moon.sky, ground),
                     std::span(all).subspan(i * moon.lookup.channels(), moon.lookup.channels()));
  }
  return all;
}

py::array_t<double> ratios_at(const Told<LitSphere>& moonlight, const Degrees& latitudes,
                              const Degrees& longitudes) {
  const auto& moon = moonlight.values["_ratios"].cast<const Ratios&>();
  std::vector<py::ssize_t> shape(latitudes.shape(), latitudes.shape() + latitudes.ndim());
  if (!std::equal(shape.begin(), shape.end(), longitudes.shape(),
                  longitudes.shape() + longitudes.ndim()))
    throw algebra::Error("latitudes and longitudes: arrays of two shapes, allowed one");
  shape.push_back(static_cast<py::ssize_t>(moon.lookup.channels()));
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
  py::class_<Ratios, std::shared_ptr<Ratios>>(package, "_Ratios")
      .def(
          "__eq__",
          [](const Ratios& a, const Ratios& b) { return are_equal(state_of(a), state_of(b)); },
          py::is_operator())
      .def(py::pickle([](const Ratios& ratios) { return state_of(ratios); },
                      [](const py::list& state) { return ratios_from(state); }));
  add_result<LitSphere>(package).def("ratio", ratios_at, "latitude_deg"_a, "longitude_deg"_a,
                                     R"(ratio(latitude_deg, longitude_deg)

Spectral irradiance on ground that faces the Sun, over that of unobstructed sunlight.

latitude_deg, longitude_deg: places on the Moon [degrees], north and east positive, of one shape
Returned: that shape and one axis more, of wavelengths)");
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
