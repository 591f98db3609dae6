// SPDX-License-Identifier: MIT
#include "verbs/camera_options.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "algebra/error.h"
#include "algebra/number.h"
#include "atmosphere/sky_luminance.h"
#include "texture/read_image.h"

namespace coppermoon::verbs {
namespace {

constexpr double arcsec_rad = std::numbers::pi / 180 / 3600;

constexpr const char *pixel_attribute = "coppermoon:pixel_arcsec",
                     *sky_attribute = "coppermoon:sky_cd_m2";

template <typename Value>
Flag add_camera_flag(CLI::App& verb, const std::string& flag, Value& value,
                     const std::string& text) {
  return add_flag(verb, flag, value, text).in(camera_group);
}

void add_optics(CLI::App& verb, CameraOptions& options) {
  add_camera_flag(verb, "--aperture", options.aperture_mm, "of the telescope or lens [mm]");
  add_camera_flag(verb, "--obstruction", options.obstruction,
                  "diameter of the secondary over the aperture's, 0 to 0.9");
  add_camera_flag(verb, "--transmission", options.transmission, "of the glass, 0.01 to 1");
  add_camera_flag(verb, "--diffraction", options.diffraction, "by the aperture, on or off")
      .one_of({"on", "off"});
  add_camera_flag(
      verb, "--seeing", options.seeing_arcsec,
      "full width at half maximum of a star through the air [arcsec], 0 to 600; 0: none");
  add_camera_flag(
      verb, "--sky", options.sky,
      "brightness of the sky [mag/arcsec2]; auto: twilight and airglow where the frame was seen "
      "from; off: none");
}

void add_sensor(CLI::App& verb, CameraOptions& options) {
  add_camera_flag(verb, "--pixel", options.pixel_um, "the side of a sensor's pixel [um]");
  add_camera_flag(verb, "--quantum-efficiency", options.quantum_efficiency,
                  "electrons for a photon of 555 nm, 0.001 to 1");
  add_camera_flag(verb, "--response", options.response,
                  fmt::format("to colours: {}", fmt::join(colour::response_names(), ", ")));
  add_camera_flag(verb, "--full-well", options.full_well_e, "of a pixel [electrons]");
  add_camera_flag(verb, "--read-noise", options.read_noise_e, "[electrons]");
  add_camera_flag(verb, "--converter-noise", options.converter_noise_dn, "behind the gain [DN]");
  add_camera_flag(verb, "--black-level", options.black_level_dn, "[DN]");
  add_camera_flag(verb, "--sensor-bits", options.sensor_bits, "of a raw number, 1 to 16");
  add_camera_flag(verb, "--noise", options.noise, "of photons and sensor, on or off")
      .one_of({"on", "off"});
  add_camera_flag(verb, "--noise-seed", options.noise_seed, "of that noise").not_negative();
}

bool any_given(const CameraOptions& o) {
  return o.aperture_mm || o.obstruction || o.transmission || o.pixel_um || o.quantum_efficiency ||
         o.full_well_e || o.read_noise_e || o.converter_noise_dn || o.black_level_dn ||
         o.seeing_arcsec || o.sensor_bits || o.response || o.diffraction || o.noise || o.sky ||
         !o.raw.empty() || !o.photograph.empty();
}

template <typename Value>
void change(Value& value, const std::optional<Value>& given) {
  if (given) value = *given;
}

void change(colour::Sensor& sensor, const CameraOptions& options) {
  change(sensor.pixel_um, options.pixel_um);
  change(sensor.quantum_efficiency, options.quantum_efficiency);
  change(sensor.full_well_e, options.full_well_e);
  change(sensor.read_noise_e, options.read_noise_e);
  change(sensor.converter_noise_dn, options.converter_noise_dn);
  change(sensor.black_level_dn, options.black_level_dn);
  change(sensor.bits, options.sensor_bits);
  change(sensor.response, options.response);
}

double sky_of(const CameraOptions& options, const Seen& seen) {
  const auto text = options.sky.value_or("auto");
  if (text == "off") return 0;
  if (text == "auto") return seen.sky_cd_m2.value_or(0);
  const auto magnitude = algebra::number_in(text);
  if (!magnitude)
    throw algebra::Error(fmt::format("sky [mag/arcsec2] = {}, allowed auto, off or 0 to 30", text));
  return atmosphere::luminance_of_magnitude_cd_m2(*magnitude);
}

double number_in(const std::filesystem::path& frame, const char* attribute) {
  return algebra::number_in(texture::read_attribute(frame, attribute).value_or("")).value_or(-1);
}

double sky_over(const almanac::Observer& observer, const almanac::SkyState& sky) {
  const auto view = almanac::view_from(observer, sky);
  const double sine = glm::dot(glm::normalize(sky.sun_m - view.position_m), view.zenith);
  constexpr double day = 5;  // an eclipsed Moon is down by then
  return atmosphere::sky_luminance_cd_m2(
      algebra::degrees(std::min(std::asin(sine) * 180 / std::numbers::pi, day)));
}

}  // namespace

void add_camera_options(CLI::App& verb, CameraOptions& options) {
  add_camera_flag(
      verb, "--camera", options.model,
      fmt::format("{}: its optics and sensor, and with them blur, noise and clipping; without: "
                  "the scene as it is",
                  fmt::join(colour::camera_names(), ", ")));
  add_optics(verb, options);
  add_sensor(verb, options);
  add_camera_flag(verb, "--raw", options.raw,
                  "also the sensor's numbers, three channels of 16 bits, .tif")
      .writes_file();
  add_camera_flag(verb, "--photograph", options.photograph,
                  "also what the camera saw, scene-linear [cd/m2], .exr")
      .writes_file();
}

std::optional<colour::Camera> camera_of(const CameraOptions& options,
                                        const std::optional<double>& f_number,
                                        const std::optional<double>& focal_length_mm) {
  if (options.model.empty()) {
    if (any_given(options))
      throw algebra::Error(
          fmt::format("a camera's aperture, sensor, noise, sky or files: allowed with --camera {}",
                      fmt::join(colour::camera_names(), ", ")));
    return std::nullopt;
  }
  auto camera = colour::camera_named(options.model);
  auto& optics = camera.optics;
  const double f_number_of_its_own = optics.focal_length_mm / optics.aperture_mm;
  change(optics.focal_length_mm, focal_length_mm);
  if (focal_length_mm && !options.aperture_mm)
    optics.aperture_mm = optics.focal_length_mm / f_number_of_its_own;
  change(optics.aperture_mm, options.aperture_mm);
  if (f_number) optics.aperture_mm = optics.focal_length_mm / *f_number;
  change(optics.obstruction, options.obstruction);
  change(optics.transmission, options.transmission);
  change(camera.sensor, options);
  change(camera.seeing_arcsec, options.seeing_arcsec);
  camera.diffraction = options.diffraction.value_or("on") == "on";
  camera.noise = options.noise.value_or("on") == "on";
  require_sound(camera);
  sky_of(options, {});
  return camera;
}

ViewOptions seen_through(const CameraOptions& options, ViewOptions view) {
  if (options.model.empty()) return view;
  const auto camera = colour::camera_named(options.model);
  view.focal_length_mm = view.focal_length_mm.value_or(camera.optics.focal_length_mm);
  view.sensor_width_mm = view.sensor_width_mm.value_or(camera.sensor.width_mm);
  return view;
}

Seen seen_by(const View& view, const almanac::SkyState& sky) {
  const auto& camera = view.camera;
  Seen seen{2 * std::tan(algebra::in_radians(camera.horizontal_field) / 2) /
                static_cast<double>(camera.width),
            {}};
  if (view.observer) seen.sky_cd_m2 = sky_over(*view.observer, sky);
  return seen;
}

Seen seen_by(const std::filesystem::path& frame) {
  Seen seen;
  seen.pixel_rad = std::max(0., number_in(frame, pixel_attribute)) * arcsec_rad;
  if (const double sky = number_in(frame, sky_attribute); sky >= 0) seen.sky_cd_m2 = sky;
  return seen;
}

void add_seen(texture::Attributes& attributes, const Seen& seen) {
  attributes[pixel_attribute] = static_cast<float>(seen.pixel_rad / arcsec_rad);
  if (seen.sky_cd_m2) attributes[sky_attribute] = static_cast<float>(*seen.sky_cd_m2);
}

colour::Photograph photographed(const CameraOptions& options, const colour::Camera& camera,
                                const colour::Image& frame, colour::WorkingSpace space,
                                const Seen& seen, const colour::Exposure& exposure,
                                std::uint64_t number) {
  const double across = static_cast<double>(frame.columns()) * camera.optics.focal_length_mm;
  colour::Shot shot{
      .exposure = exposure,
      .pixel_rad = seen.pixel_rad > 0 ? seen.pixel_rad : camera.sensor.width_mm / across,
      .sky_cd_m2 = sky_of(options, seen),
      .seed = options.noise_seed,
      .frame = number};
  return colour::photographed(frame, space, camera, shot);
}

}  // namespace coppermoon::verbs
