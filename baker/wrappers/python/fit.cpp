// SPDX-License-Identifier: MIT
#include "uses/fit/fit_results.h"

#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <filesystem>

#include "uses/light/photometer.h"
#include "wrappers/python/arguments.h"
#include "wrappers/python/computing.h"
#include "wrappers/python/fields.h"
#include "wrappers/python/nouns.h"
#include "wrappers/python/requests.h"
#include "wrappers/python/results.h"

namespace coppermoon::python {

/// Converts the fit's results for one night to Python, including the whole tone curve and all measured light.
template <>
Told<uses::FittedNight> told(const uses::FittedNight& night) {
  Told<uses::FittedNight> made;
  describe(Keeps{made.values}, night);
  if (night.curve) {
    const auto& numbers = night.curve->numbers;
    made.values["tone_curve"] = array_of(std::vector<double>(numbers.begin(), numbers.end()));
  }
  const auto size = static_cast<py::ssize_t>(night.light.size());
  made.values["light"] = array_of<uses::MeasuredLight>(night.light, {size});
  return made;
}

namespace {

using uses::EclipsePhotograph, uses::FitReport, uses::FittedNight;

/// Reads measured magnitudes from tuples of moment, band, magnitude and, if known, the magnitude's error.
std::vector<uses::MeasuredMagnitude> measured_by(const py::iterable& rows) {
  std::vector<uses::MeasuredMagnitude> all;
  for (const auto& each : rows) {
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

/// The set of unknowns with the given name; nullopt if no name is given, so that the fit picks a set to suit its air.
std::optional<uses::Unknowns> unknowns_named(const std::optional<std::string>& name) {
  if (!name) return std::nullopt;
  if (*name == "factors") return uses::Unknowns::factors;
  if (*name == "amounts") return uses::Unknowns::amounts;
  throw algebra::Error(fmt::format("unknowns = {}, allowed factors or amounts", *name));
}

Told<FitReport> fit_of(const py::iterable& magnitudes, std::vector<EclipsePhotograph> photographs,
                       const std::optional<Place>& at, const std::string& camera,
                       std::optional<double> exposure_error, std::optional<double> shutter_error,
                       std::optional<double> white_balance_error, double clock_error_s,
                       bool half_hours_free, const std::optional<std::string>& unknowns,
                       const std::optional<uses::Air>& air,
                       const std::optional<uses::LightRequest>& light, const Callback& callback,
                       const py::kwargs& more) {
  algebra::require_within("clock_error_s", clock_error_s, 0, 3600);
  TextureKeywords asked{.moon = {}};
  take_objects(asked, air, light, at);
  take(fit_keywords(asked), "fit", more);
  const uses::FitRequest request{.unknowns = unknowns_named(unknowns),
                                 .photographs = std::move(photographs),
                                 .magnitudes = measured_by(magnitudes),
                                 .moon = asked.moon,
                                 .view = asked.view,
                                 .camera = camera,
                                 .exposure_error = exposure_error,
                                 .shutter_error = shutter_error,
                                 .white_balance_error = white_balance_error,
                                 .clock_error_s = clock_error_s,
                                 .half_hours_free = half_hours_free};
  return told(computed(callback, [&](const algebra::Progress& progress) {
    return uses::fitted_air(request, progress);
  }));
}

void add_photograph(py::module_& package) {
  using namespace py::literals;
  py::class_<EclipsePhotograph>(
      package, "Photograph",
      R"(Photograph(file, when, *, coding='as-file-says', exposure_time_s=None, iso=None, f_number=None)

A photograph of an eclipsed Moon, and what is known of how it was taken.

file: any image, or a camera's raw file
when: the moment when it was taken
coding: how its numbers stand for light, 'as-file-says', 'srgb', 'linear' or 'camera' (its own tone curve, which is then found)
exposure_time_s, iso, f_number: without them as its header says
)")
      .def(py::init([](const std::filesystem::path& file, const Moment& when,
                       texture::Coding coding, std::optional<double> exposure_time_s,
                       std::optional<double> iso, std::optional<double> f_number) {
             return EclipsePhotograph{
                 file.string(), when.seen_from({}), coding, exposure_time_s, iso, f_number};
           }),
           "file"_a, "when"_a, py::kw_only(), "coding"_a = texture::Coding::as_file_says,
           "exposure_time_s"_a = py::none(), "iso"_a = py::none(), "f_number"_a = py::none())
      .def_readonly("file", &EclipsePhotograph::file, "its path")
      .def_property_readonly(
          "instant", [](const EclipsePhotograph& one) { return datetime_of(one.instant); },
          "the moment when it was taken")
      .def_readonly("coding", &EclipsePhotograph::coding, "how its numbers stand for light")
      .def_readonly("exposure_time_s", &EclipsePhotograph::time_s, "None: as its header says")
      .def_readonly("iso", &EclipsePhotograph::iso, "None: as its header says")
      .def_readonly("f_number", &EclipsePhotograph::f_number, "None: as its header says")
      .def("__repr__", [](const EclipsePhotograph& one) {
        return fmt::format("<Photograph {} of {}>", one.file, almanac::utc_text(one.instant));
      });
}

}  // namespace

void add_fit(py::module_& package) {
  using namespace py::literals;
  PYBIND11_NUMPY_DTYPE(uses::MeasuredLight, distance_km, channel, light, model, error);
  add_photograph(package);
  add_result<uses::Estimate>(package);
  add_result<uses::ClippedAt>(package);
  add_result<uses::ReadPhotograph>(package);
  add_result<uses::ClockError>(package);
  add_result<uses::Misfit>(package);
  add_result<FittedNight>(package).def_property_readonly(
      "light", [](const Told<FittedNight>& night) { return night.values["light"]; },
      "light over full sunlight, in steps of 100 km: a structured array of distance_km from "
      "the shadow's axis, channel (0 red), light, model (of the air that was found) and error "
      "(standard, of the logarithm of light)");
  add_result<uses::Suspicion>(package);
  add_result<FitReport>(package);
  TextureKeywords keywords{.moon = {}};
  const auto parameters = fit_keywords(keywords);
  const auto doc = fmt::format(
      R"(fit(magnitudes=(), *, photographs=(), at=None, camera='', exposure_error=None, shutter_error=None, white_balance_error=None, clock_error_s=0.0, half_hours_free=False, unknowns=None, air=None, light=None, {}, progress=None)

The aerosol, cloud and ozone that explain photographs of the Moon and measured magnitudes of the whole Moon, of one
eclipse or several, all at once.

magnitudes: (moment, band, magnitude) or (moment, band, magnitude, error): band 'B', 'V' or 'R'; reduced to the Earth's
    centre and to above the air; error 0.001 to 0.99 mag, default: 0.1
photographs: Photograph(file, when); those of one camera and eclipse share a clock, a tone curve and a factor of exposure. One of
    several that cannot be used is left out
at: where the photographs were taken, a city or (latitude, longitude) in degrees
camera: name of the camera whose saturation is meant, as the command knows it; default: ISO 12232's
exposure_error: standard, of the exposures' logarithm, 0.001 to 10; None: 0.1, of a camera's own tone curve free
shutter_error: standard, of the logarithm of one exposure beside the night's others, 0.001 to 10; None: 0.03, of a camera's own JPEGs 0.1
white_balance_error: standard, of red and blue over green, 0.001 to 10; None: 0.03, of a camera's own JPEGs 0.3, or 0.06 to 0.2 if their header has the gains as shot
clock_error_s: standard, of each camera's clock, 0 to 3600; its own error is then found
half_hours_free: moments may be wrong by any whole number of half hours besides
unknowns: 'factors' on the stratospheric aerosol, chance of cloud and ozone that the month has; 'amounts' of dust, of a
    deck of cloud and of ozone, the same everywhere; None: factors, in air without a month amounts
air: all but the unknowns
light: limb_darkening, scattered_light and starlight; nothing else of it counts
{}progress: called with the fraction that is done, some times a second

>>> when = '2018-07-27T20:21:45Z'
>>> found = coppermoon.fit([(when, 'B', 2.55), (when, 'V', -0.47), (when, 'R', -3.20)],
...                        air=coppermoon.Air(atmosphere='undated'),
...                        light=coppermoon.Light(scattered_light='off'))
>>> found.explained, found.numbers
(True, 3)
)",
      signature_of(parameters), lines_of(parameters));
  package.def("fit", fit_of, "magnitudes"_a = py::tuple(), py::kw_only(),
              "photographs"_a = std::vector<EclipsePhotograph>{}, "at"_a = py::none(),
              "camera"_a = "", "exposure_error"_a = py::none(), "shutter_error"_a = py::none(),
              "white_balance_error"_a = py::none(), "clock_error_s"_a = 0.,
              "half_hours_free"_a = false, "unknowns"_a = py::none(), "air"_a = py::none(),
              "light"_a = py::none(), "progress"_a = py::none(), doc.c_str());
}

}  // namespace coppermoon::python
