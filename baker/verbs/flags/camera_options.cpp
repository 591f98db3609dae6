// SPDX-License-Identifier: MIT
#include "verbs/flags/camera_options.h"

#include <fmt/ranges.h>

#include "algebra/error.h"
#include "algebra/number.h"
#include "atmosphere/sky_luminance.h"

namespace coppermoon::verbs {
namespace {

/// Nothing for "auto".
std::optional<double> sky_luminance_from(const std::string& text) {
  if (text == "auto") return std::nullopt;
  if (text == "off") return 0;
  const auto magnitude = algebra::number_in(text);
  if (!magnitude)
    throw algebra::Error(fmt::format("sky [mag/arcsec2] = {}, allowed auto, off or 0 to 30", text));
  return atmosphere::luminance_of_magnitude_cd_m2(*magnitude);
}

template <typename Value>
Flag add_camera_flag(CLI::App& verb, const std::string& flag, Value& value,
                     const std::string& text) {
  return add_flag(verb, flag, value, text).in(camera_group);
}

void add_optics(CLI::App& verb, uses::CameraRequest& request) {
  add_camera_flag(verb, "--aperture", request.aperture_mm, "of the telescope or lens [mm]");
  add_camera_flag(verb, "--obstruction", request.obstruction,
                  "diameter of the secondary over the aperture's, 0 to 0.9");
  add_camera_flag(verb, "--transmission", request.transmission, "of the glass, 0.01 to 1");
  add_on_off(verb, "--diffraction", request.diffraction, "by the aperture, on or off")
      .in(camera_group);
  add_camera_flag(
      verb, "--seeing", request.seeing_arcsec,
      "full width at half maximum of a star through the air [arcsec], 0 to 600; 0: none");
  add_parsed(
      verb, "--sky",
      [&request](const std::string& text) { request.sky_cd_m2 = sky_luminance_from(text); },
      "brightness of the sky [mag/arcsec2]; auto: twilight and airglow where the frame was seen "
      "from; off: none")
      .in(camera_group);
}

void add_sensor(CLI::App& verb, uses::CameraRequest& request) {
  add_camera_flag(verb, "--pixel", request.pixel_um, "the side of a sensor's pixel [um]");
  add_camera_flag(verb, "--quantum-efficiency", request.quantum_efficiency,
                  "electrons for a photon of 555 nm, 0.001 to 1");
  add_camera_flag(verb, "--response", request.response,
                  fmt::format("to colours: {}", fmt::join(colour::response_names(), ", ")));
  add_camera_flag(verb, "--full-well", request.full_well_e, "of a pixel [electrons]");
  add_camera_flag(verb, "--read-noise", request.read_noise_e, "[electrons]");
  add_camera_flag(verb, "--converter-noise", request.converter_noise_dn, "behind the gain [DN]");
  add_camera_flag(verb, "--black-level", request.black_level_dn, "[DN]");
  add_camera_flag(verb, "--sensor-bits", request.sensor_bits, "of a raw number, 1 to 16");
  add_on_off(verb, "--noise", request.noise, "of photons and sensor, on or off").in(camera_group);
  add_camera_flag(verb, "--noise-seed", request.noise_seed, "of that noise").not_negative();
}

}  // namespace

void add_camera_options(CLI::App& verb, uses::CameraRequest& request) {
  add_camera_flag(
      verb, "--camera", request.model,
      fmt::format("{}: its optics and sensor, and with them blur, noise and clipping; without: "
                  "the scene as it is",
                  fmt::join(colour::camera_names(), ", ")));
  add_optics(verb, request);
  add_sensor(verb, request);
}

void add_camera_file_options(CLI::App& verb, uses::CameraRequest& request) {
  add_parsed(
      verb, "--raw", [&request](const std::string& text) { request.raw = text; },
      "also the sensor's numbers, three channels of 16 bits, .tif")
      .in(camera_group)
      .writes_file();
  add_parsed(
      verb, "--photograph", [&request](const std::string& text) { request.photograph = text; },
      "also what the camera saw, scene-linear [cd/m2], .exr")
      .in(camera_group)
      .writes_file();
}

}  // namespace coppermoon::verbs
