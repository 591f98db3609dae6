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

/// Nothing for "auto".
std::optional<double> glow_from(const std::string& text) {
  if (text == "auto") return std::nullopt;
  const auto share = algebra::number_in(text);
  if (!share) throw algebra::Error(fmt::format("glow = {}, allowed auto or 0 to 0.5", text));
  return share;
}

template <typename Value>
Flag add_camera_flag(CLI::App& verb, const std::string& flag, Value& value,
                     const std::string& text) {
  return add_flag(verb, flag, value, text).in(camera_group);
}

void add_optics(CLI::App& verb, uses::CameraRequest& request) {
  add_camera_flag(verb, "--aperture", request.aperture_mm,
                  "aperture of the telescope or lens [mm]");
  add_camera_flag(verb, "--obstruction", request.obstruction,
                  "diameter of the secondary mirror over the aperture, 0 to 0.9");
  add_camera_flag(verb, "--transmission", request.transmission,
                  "share of the light that the optics transmit, 0.01 to 1");
  add_on_off(verb, "--diffraction", request.diffraction, "blur by diffraction at the aperture")
      .in(camera_group);
  add_camera_flag(verb, "--seeing", request.seeing_arcsec,
                  "seeing: full width at half maximum of a star's image [arcsec], 0 to 600");
  add_parsed(
      verb, "--glow", [&request](const std::string& text) { request.glow = glow_from(text); },
      "glow about bright ground: share of the light that optics and air scatter, 0 to 0.5; auto: "
      "the camera's, 0.02 for lenses and 0.05 for mirrors",
      "auto")
      .in(camera_group);
  add_parsed(
      verb, "--sky",
      [&request](const std::string& text) { request.sky_cd_m2 = sky_luminance_from(text); },
      "brightness of the sky [mag/arcsec2]; auto: twilight and airglow at the observer's place; "
      "off: a black sky")
      .in(camera_group);
}

void add_sensor(CLI::App& verb, uses::CameraRequest& request) {
  add_camera_flag(verb, "--pixel", request.pixel_um, "side of a pixel of the sensor [um]");
  add_camera_flag(verb, "--quantum-efficiency", request.quantum_efficiency,
                  "quantum efficiency: electrons per photon of 555 nm, 0.001 to 1");
  add_camera_flag(verb, "--response", request.response,
                  fmt::format("response of the sensor to colours: {}",
                              fmt::join(colour::response_names(), ", ")));
  add_camera_flag(verb, "--full-well", request.full_well_e,
                  "full-well capacity of a pixel [electrons]");
  add_camera_flag(verb, "--read-noise", request.read_noise_e, "read noise of a pixel [electrons]");
  add_camera_flag(verb, "--converter-noise", request.converter_noise_dn,
                  "noise of the converter, behind the gain [DN]");
  add_camera_flag(verb, "--black-level", request.black_level_dn, "black level of raw numbers [DN]");
  add_camera_flag(verb, "--sensor-bits", request.sensor_bits, "bits of a raw number, 1 to 16");
  add_on_off(verb, "--noise", request.noise, "noise of photons and sensor").in(camera_group);
  add_camera_flag(verb, "--noise-seed", request.noise_seed, "seed of the noise").not_negative();
}

}  // namespace

void add_camera_options(CLI::App& verb, uses::CameraRequest& request) {
  add_camera_flag(
      verb, "--camera", request.model,
      fmt::format(
          "camera: {}. Its optics and sensor add blur, noise and clipping; default: the scene "
          "as it is",
          fmt::join(colour::camera_names(), ", ")));
  add_optics(verb, request);
  add_sensor(verb, request);
}

void add_camera_file_options(CLI::App& verb, uses::CameraRequest& request) {
  add_parsed(
      verb, "--raw", [&request](const std::string& text) { request.raw = text; },
      "writes the sensor's raw numbers too: .tif, three channels of 16 bits, or .dng, its mosaic of "
      "colour filters for raw converters")
      .in(camera_group)
      .writes_file();
  add_parsed(
      verb, "--photograph", [&request](const std::string& text) { request.photograph = text; },
      "writes what the camera saw too: .exr, scene-linear [cd/m2]")
      .in(camera_group)
      .writes_file();
}

}  // namespace coppermoon::verbs
