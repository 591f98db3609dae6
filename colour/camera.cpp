// SPDX-License-Identifier: MIT
#include "colour/camera.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <iterator>
#include <numbers>

#include "algebra/error.h"
#include "algebra/table.h"
#include "colour/camera_spectra.h"
#include "colour/tables.h"
#include "colour/working_space.h"

namespace coppermoon::colour {
namespace {

using std::numbers::pi;
using TextTable = std::vector<std::vector<std::string>>;

/// Photons per second in one lumen of 555 nm light: λ / (683 h c).
constexpr double photons_per_lm_s = 4.0914e15;

std::vector<std::string> first_column(const TextTable& table) {
  std::vector<std::string> names;
  for (std::size_t i = 1; i < table.size(); ++i) names.push_back(table[i][0]);
  return names;
}

/// A table row, found by its first cell. Its cells are read by column name.
class Row {
 public:
  Row(const TextTable& table, std::string_view what, std::string_view name)
      : header_(table.front()) {
    const auto row =
        std::find_if(table.begin() + 1, table.end(), [&](const auto& r) { return r[0] == name; });
    if (row == table.end())
      throw algebra::Error(
          fmt::format("{} = {}, allowed {}", what, name, fmt::join(first_column(table), ", ")));
    cells_ = *row;
  }

  const std::string& text(std::string_view column) const {
    const auto at = std::find(header_.begin(), header_.end(), column);
    return cells_[static_cast<std::size_t>(at - header_.begin())];
  }
  double operator[](std::string_view column) const { return std::stod(text(column)); }

 private:
  std::vector<std::string> header_, cells_;
};

const TextTable& cameras() {
  static const auto table = algebra::parse_text_table(tables::cameras());
  return table;
}

const TextTable& responses() {
  static const auto table = algebra::parse_text_table(tables::camera_responses());
  return table;
}

glm::dvec3 white_xyz() {
  return glm::inverse(channels_from_xyz(WorkingSpace::linear_rec709)) * glm::dvec3(1);
}

Response of_matrix(const glm::dmat3& from_xyz) {
  const glm::dvec3 white = from_xyz * white_xyz();
  Response response{from_xyz, white / std::max({white.r, white.g, white.b})};
  for (int column = 0; column < 3; ++column) response.from_xyz[column] /= white;
  return response;
}

/// Ratio of focal-plane illuminance to scene luminance, multiplied by the f-number squared: π/4 τ (1 − ε²).
double light_passed(const CameraOptics& optics) {
  return pi / 4 * optics.transmission * (1 - optics.obstruction * optics.obstruction);
}

/// Electrons that a pixel collects per lux second of exposure.
double electrons_per_lx_s(const Sensor& sensor) {
  const double side_m = sensor.pixel_um * 1e-6;
  return sensor.quantum_efficiency * photons_per_lm_s * side_m * side_m;
}

/// Number of electrons at which the converter's range is full, regardless of the full-well capacity.
double saturation_e(const Sensor& sensor, double iso) {
  exposure_scale({.iso = iso});  // throws if the ISO speed is out of range
  return electrons_per_lx_s(sensor) * saturation_exposure_lx_s / iso;
}

/// Focal-plane exposure per unit of scene luminance [lx s per cd/m²].
double exposure_lx_s(const Camera& camera, const Exposure& exposure) {
  exposure_scale(exposure);  // throws if a setting is out of range
  return light_passed(camera.optics) * exposure.time_s / (exposure.f_number * exposure.f_number);
}

}  // namespace

std::vector<std::string> camera_names() { return first_column(cameras()); }

Camera camera_named(std::string_view name) {
  if (const auto known = camera_names(); std::ranges::find(known, name) == known.end())
    throw algebra::Error(
        fmt::format("camera = {}, allowed {}; of a maker's camera, response says the colours, "
                    "focal-length and sensor-width the field",
                    name, fmt::join(known, ", ")));
  const Row row(cameras(), "camera", name);
  Camera camera;
  camera.optics = {row["focal_length_mm"], row["aperture_mm"], row["obstruction"],
                   row["transmission"]};
  camera.sensor = {.width_mm = row["sensor_width_mm"],
                   .pixel_um = row["pixel_um"],
                   .quantum_efficiency = row["quantum_efficiency"],
                   .full_well_e = row["full_well_e"],
                   .read_noise_e = row["read_noise_e"],
                   .converter_noise_dn = row["converter_noise_dn"],
                   .black_level_dn = row["black_level_dn"],
                   .bits = static_cast<int>(row["bits"]),
                   .response = row.text("response")};
  camera.glow = row["glow"];
  return camera;
}

std::vector<std::string> response_names() {
  auto names = first_column(responses());
  names.insert(names.begin(), {"colorimetric", "luminance"});
  std::ranges::copy(camera_spectra_names(), std::back_inserter(names));
  return names;
}

Response response_named(const std::string& name) {
  if (name == "colorimetric") return of_matrix(channels_from_xyz(WorkingSpace::linear_rec709));
  if (name == "luminance") {
    glm::dmat3 luminance(0);
    luminance[1] = glm::dvec3(1);
    return {luminance, glm::dvec3(1)};
  }
  if (is_spectral(name)) {
    const auto camera = camera_spectra(name);
    auto channels = glm::inverse(camera.xyz_from_balanced);
    for (int column = 0; column < 3; ++column) channels[column] *= camera.daylight;
    return of_matrix(channels);
  }
  const auto names = response_names();
  if (std::ranges::find(names, name) == names.end())
    throw algebra::Error(
        fmt::format("response = {}, allowed {}, or a .csv file", name, fmt::join(names, ", ")));
  const Row row(responses(), "response", name);
  return of_matrix({row["rx"], row["gx"], row["bx"],  // one matrix column per line
                    row["ry"], row["gy"], row["by"],  //
                    row["rz"], row["gz"], row["bz"]});
}

double electrons_per_cd_m2(const Camera& camera, const Exposure& exposure) {
  require_sound(camera);
  return electrons_per_lx_s(camera.sensor) * exposure_lx_s(camera, exposure);
}

Gain gain_at(const Camera& camera, double iso) {
  require_sound(camera);
  const auto& sensor = camera.sensor;
  const double range_dn = std::exp2(sensor.bits) - 1 - sensor.black_level_dn,
               dn_per_electron = range_dn / saturation_e(sensor, iso),
               white_dn = std::floor(std::min(range_dn, dn_per_electron * sensor.full_well_e));
  algebra::require_within(
      fmt::format("white of the sensor at ISO {}, above its black level [DN]", iso), white_dn, 1,
      65535);
  return {dn_per_electron, white_dn};
}

double saturation_cd_m2(const Camera& camera, const Exposure& exposure) {
  const double white_e =
      std::min(saturation_e(camera.sensor, exposure.iso), camera.sensor.full_well_e);
  return white_e / electrons_per_cd_m2(camera, exposure);
}

void require_sound(const Camera& camera) {
  const auto& [optics, sensor, seeing, glow, diffraction, noise] = camera;
  using algebra::require_within;
  require_within("focal length [mm]", optics.focal_length_mm, 1, 1e6);
  require_within("aperture [mm]", optics.aperture_mm, 0.1, 1e5);
  require_within("obstruction", optics.obstruction, 0, 0.9);
  require_within("transmission", optics.transmission, 0.01, 1);
  require_within("sensor width [mm]", sensor.width_mm, 0.1, 1000);
  require_within("pixel [um]", sensor.pixel_um, 0.1, 1000);
  require_within("quantum efficiency", sensor.quantum_efficiency, 1e-3, 1);
  require_within("full well [e]", sensor.full_well_e, 10, 1e9);
  require_within("read noise [e]", sensor.read_noise_e, 0, 1e4);
  require_within("converter noise [DN]", sensor.converter_noise_dn, 0, 1e4);
  require_within("bits of the sensor", sensor.bits, 1, 16);
  require_within("black level [DN]", sensor.black_level_dn, 0, std::exp2(sensor.bits - 1));
  require_within("seeing [arcsec]", seeing, 0, 600);
  require_within("glow", glow, 0, 0.5);
  response_named(sensor.response);
}

}  // namespace coppermoon::colour
