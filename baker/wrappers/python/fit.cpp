// SPDX-License-Identifier: MIT
#include "uses/study/fit.h"

#include <algorithm>
#include <cmath>

#include "uses/light/photometric_bands.h"
#include "wrappers/python/arguments.h"
#include "wrappers/python/computing.h"
#include "wrappers/python/nouns.h"
#include "wrappers/python/requests.h"

namespace coppermoon::python {
namespace {

using uses::AirFit, uses::Estimate;

/// Measured as tuples of moment, band, magnitude and, if known, its error.
std::vector<uses::MeasuredMagnitude> measured_by(const py::iterable& told) {
  std::vector<uses::MeasuredMagnitude> all;
  for (const auto& each : told) {
    if (!py::isinstance<py::sequence>(each) || py::isinstance<py::str>(each) || py::len(each) < 3 ||
        py::len(each) > 4)
      throw py::type_error(
          fmt::format("{}: no measured magnitude, allowed (moment, band, magnitude) or (moment, "
                      "band, magnitude, error)",
                      py::repr(each).cast<std::string>()));
    const auto row = py::reinterpret_borrow<py::sequence>(each);
    try {
      auto& one = all.emplace_back(uses::MeasuredMagnitude{
          instant_of(row[0]), row[1].cast<std::string>(), row[2].cast<double>()});
      if (py::len(row) == 4) one.error = row[3].cast<double>();
      const auto bands = uses::photometric_bands();
      if (std::ranges::find(bands, one.band, &uses::PhotometricBand::name) == bands.end())
        throw algebra::Error(fmt::format("band = {}, allowed B, V or R", one.band));
      algebra::require_within("magnitude", one.magnitude, -30, 30);
      algebra::require_within("error of a magnitude", one.error, 0.001, 0.99);
    } catch (const py::cast_error&) {
      throw py::type_error(fmt::format("{}: allowed a text for the band, numbers for the others",
                                       py::repr(each).cast<std::string>()));
    }
  }
  return all;
}

/// An unknown that was found, its logarithm undone where that was sought.
Estimate plain(const Estimate& found, bool logarithm) {
  if (!logarithm) return found;
  return {std::exp(found.median), std::exp(found.low), std::exp(found.high), found.information};
}

AirFit fit_of(const py::iterable& magnitudes, const std::optional<uses::Air>& air,
              const std::optional<uses::LightRequest>& light, const std::string& albedo_map,
              std::optional<uses::AlbedoEncoding> albedo_encoding, double albedo_exponent,
              surface::Photometry photometry, const Told& told) {
  const uses::FitRequest request{
      .magnitudes = measured_by(magnitudes),
      .moon = moon_request(light_request(air, light),
                           {albedo_map, albedo_encoding, albedo_exponent, photometry, false})};
  return computed(told, [&](const algebra::Progress&) { return uses::fitted_air(request).fit; });
}

py::array_t<double> correlation_of(const AirFit& fit) {
  algebra::Grid<double> all(3, 3);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) all(i, j) = fit.posterior.correlation[i][j];
  return array_of(std::move(all));
}

void add_estimate(py::module_& package) {
  py::class_<Estimate>(package, "Estimate", "One number of the air, as far as it is known.")
      .def_readonly("median", &Estimate::median, "as likely above as below")
      .def_readonly("low", &Estimate::low, "where the middle 68 % of the probability begins")
      .def_readonly("high", &Estimate::high, "where the middle 68 % of the probability ends")
      .def_readonly("information", &Estimate::information,
                    "1 - its variance over that before anything was seen: 0 (nothing told) to 1")
      .def("__repr__", [](const Estimate& e) {
        return fmt::format("<Estimate {:.3g}, {:.3g} to {:.3g}>", e.median, e.low, e.high);
      });
}

}  // namespace

void add_fit(py::module_& package) {
  using namespace py::literals;
  add_estimate(package);
  const auto estimate = [](std::size_t unknown, bool logarithm) {
    return [=](const AirFit& fit) { return plain(fit.posterior.estimates[unknown], logarithm); };
  };
  py::class_<AirFit>(package, "Fit", "The air that explains what was measured.")
      .def_property_readonly("dust_extinction", estimate(0, true),
                             "extinction of a grey layer of dust [1/m]")
      .def_property_readonly("cloud_cover", estimate(1, false),
                             "share of the Earth's limb where cloud stops the light, 0 to 1")
      .def_property_readonly("ozone_du", estimate(2, false), "vertical column of ozone [DU]")
      .def_property_readonly("correlation", correlation_of,
                             "of the logarithm of dust, cloud cover and ozone, shape (3, 3)")
      .def_property_readonly(
          "chi_squared", [](const AirFit& fit) { return fit.posterior.least_chi_squared; },
          "sum of squared differences over the errors, of the best air")
      .def_readonly("numbers", &AirFit::numbers, "how many numbers were compared")
      .def_property_readonly(
          "explained", [](const AirFit& fit) { return uses::explains(fit); },
          "whether that air explains them; if not, the estimates mean little");
  package.def(
      "fit", fit_of, "magnitudes"_a, py::kw_only(), "air"_a = py::none(), "light"_a = py::none(),
      "albedo_map"_a = "auto", "albedo_encoding"_a = py::none(), "albedo_exponent"_a = 1.,
      "photometry"_a = surface::Photometry::lommel_seeliger_rolo, "progress"_a = py::none(),
      R"(fit(magnitudes, *, air=None, light=None, albedo_map='auto', albedo_encoding=None, albedo_exponent=1.0, photometry='lommel-seeliger-rolo', progress=None)

The dust, cloud cover and ozone that explain measured magnitudes of the whole Moon, of one eclipse or several.

magnitudes: (moment, band, magnitude) or (moment, band, magnitude, error): band 'B', 'V' or 'R'; reduced to the Earth's
    centre and to above the air; error 0.001 to 0.99 mag, 0.1 unless given
air: all but dust, cloud cover and ozone
light: limb_darkening, scattered_light and starlight; nothing else of it counts
progress: called some times a second; Ctrl-C is answered when the fit ends, some ten seconds later

>>> when = '2018-07-27T20:21:45Z'
>>> found = coppermoon.fit([(when, 'B', 2.55), (when, 'V', -0.47), (when, 'R', -3.20)],
...                        air=coppermoon.Air(atmosphere='undated'), albedo_map='built-in',
...                        light=coppermoon.Light(scattered_light='off'))
>>> found.explained, found.numbers
(True, 3)
)");
}

}  // namespace coppermoon::python
