// SPDX-License-Identifier: MIT
#include "uses/picture/camera.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "algebra/error.h"
#include "algebra/number.h"
#include "colour/camera_spectra.h"
#include "texture/read_image.h"
#include "uses/picture/pixels.h"

namespace coppermoon::uses {
namespace {

constexpr double arcsec_rad = std::numbers::pi / 180 / 3600;

constexpr const char *pixel_attribute = "coppermoon:pixel_arcsec",
                     *sky_attribute = "coppermoon:sky_cd_m2",
                     *sky_place_attribute = "coppermoon:sky", *sky_place = "in the frame",
                     *disc_attribute = "coppermoon:disc_outline";

bool any_given(const CameraRequest& o) {
  return o.aperture_mm || o.obstruction || o.transmission || o.pixel_um || o.quantum_efficiency ||
         o.full_well_e || o.read_noise_e || o.converter_noise_dn || o.black_level_dn ||
         o.seeing_arcsec || o.glow || o.sensor_bits ||
         (o.response && *o.response != "colorimetric" && !spectral_response(o)) || o.diffraction ||
         o.noise || !o.raw.empty() || !o.photograph.empty();
}

template <typename Value>
void change(Value& value, const std::optional<Value>& given) {
  if (given) value = *given;
}

void change(colour::Sensor& sensor, const CameraRequest& request) {
  change(sensor.pixel_um, request.pixel_um);
  change(sensor.quantum_efficiency, request.quantum_efficiency);
  change(sensor.full_well_e, request.full_well_e);
  change(sensor.read_noise_e, request.read_noise_e);
  change(sensor.converter_noise_dn, request.converter_noise_dn);
  change(sensor.black_level_dn, request.black_level_dn);
  change(sensor.bits, request.sensor_bits);
  change(sensor.response, request.response);
}

double number_in(const std::filesystem::path& frame, const char* attribute) {
  return algebra::number_in(texture::read_attribute(frame, attribute).value_or("")).value_or(-1);
}

bool holds_its_sky(const std::filesystem::path& frame) {
  return texture::read_attribute(frame, sky_place_attribute) == sky_place;
}

}  // namespace

std::optional<colour::Camera> camera_of(const CameraRequest& request,
                                        const std::optional<double>& f_number,
                                        const std::optional<double>& focal_length_mm) {
  if (request.model.empty()) {
    if (any_given(request))
      throw algebra::Error(
          fmt::format("aperture, sensor, noise and files of a camera need a camera: {}",
                      fmt::join(colour::camera_names(), ", ")));
    return std::nullopt;
  }
  auto camera = colour::camera_named(request.model);
  auto& optics = camera.optics;
  const double f_number_of_its_own = optics.focal_length_mm / optics.aperture_mm;
  change(optics.focal_length_mm, focal_length_mm);
  if (focal_length_mm && !request.aperture_mm)
    optics.aperture_mm = optics.focal_length_mm / f_number_of_its_own;
  change(optics.aperture_mm, request.aperture_mm);
  if (f_number) optics.aperture_mm = optics.focal_length_mm / *f_number;
  change(optics.obstruction, request.obstruction);
  change(optics.transmission, request.transmission);
  change(camera.sensor, request);
  change(camera.seeing_arcsec, request.seeing_arcsec);
  change(camera.glow, request.glow);
  camera.diffraction = request.diffraction.value_or(true);
  camera.noise = request.noise.value_or(true);
  require_sound(camera);
  return camera;
}

std::optional<std::string> spectral_response(const CameraRequest& request) {
  return request.response && colour::is_spectral(*request.response) ? request.response
                                                                    : std::nullopt;
}

ViewRequest seen_through(const CameraRequest& request, ViewRequest view) {
  if (request.model.empty()) return view;
  const auto camera = colour::camera_named(request.model);
  view.focal_length_mm = view.focal_length_mm.value_or(camera.optics.focal_length_mm);
  view.sensor_width_mm = view.sensor_width_mm.value_or(camera.sensor.width_mm);
  return view;
}

double pixel_rad_of(const povray_scenes::SceneCamera& camera) {
  return 2 * std::tan(algebra::in_radians(camera.horizontal_field) / 2) /
         static_cast<double>(camera.width);
}

SeenFrame seen_by(const View& view, const FrameSky& sky) {
  return {pixel_rad_of(view.camera), sky.at_moon_cd_m2(), disc_outline(view.camera)};
}

SeenFrame seen_by(const std::filesystem::path& frame) {
  SeenFrame seen;
  seen.pixel_rad = std::max(0., number_in(frame, pixel_attribute)) * arcsec_rad;
  if (const double sky = number_in(frame, sky_attribute); sky > 0 && holds_its_sky(frame))
    seen.sky_cd_m2 = sky;
  seen.disc = outline_in(texture::read_attribute(frame, disc_attribute).value_or(""));
  seen.of_another_program = !texture::read_attribute(frame, "coppermoon:version");
  return seen;
}

double sky_left_out(const std::filesystem::path& frame) {
  return holds_its_sky(frame) ? 0 : std::max(0., number_in(frame, sky_attribute));
}

void add_seen(texture::Attributes& attributes, const SeenFrame& seen) {
  attributes[pixel_attribute] = static_cast<float>(seen.pixel_rad / arcsec_rad);
  if (seen.sky_cd_m2 > 0) {
    attributes[sky_attribute] = static_cast<float>(seen.sky_cd_m2);
    attributes[sky_place_attribute] = std::string(sky_place);
  }
  if (seen.disc) attributes[disc_attribute] = text_of(*seen.disc);
}

colour::Photograph photographed(const CameraRequest& request, const colour::Camera& camera,
                                const Frame& frame, const colour::Exposure& exposure) {
  auto pixels = pixels_of(frame.light);
  const auto& seen = frame.seen;
  const auto white = colour::white(frame.space);
  for (auto& pixel : pixels.values())
    for (int k = 0; k < 3; ++k)
      pixel[static_cast<std::size_t>(k)] -= static_cast<float>(seen.sky_cd_m2 * white[k]);
  const double across = static_cast<double>(pixels.columns()) * camera.optics.focal_length_mm;
  const colour::Shot shot{
      .exposure = exposure,
      .pixel_rad = seen.pixel_rad > 0 ? seen.pixel_rad : camera.sensor.width_mm / across,
      .sky_cd_m2 = seen.sky_cd_m2,
      .seed = request.noise_seed,
      .frame = frame.number};
  return colour::photographed(pixels, frame.space, camera, shot);
}

}  // namespace coppermoon::uses
