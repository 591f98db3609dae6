// SPDX-License-Identifier: MIT
#include "uses/picture/camera_request.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "algebra/error.h"
#include "algebra/number.h"
#include "colour/camera_spectra.h"
#include "texture/read_image.h"
#include "texture/write_dng.h"
#include "texture/write_image.h"
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

bool is_dng(const std::filesystem::path& file) { return file.extension() == ".dng"; }

/// Keeps one channel of every pixel, like a Bayer mosaic: rows of red and green alternate with rows of green and blue.
algebra::Grid<std::uint16_t> mosaic_of(const algebra::Grid<colour::RawPixel>& raw) {
  algebra::Grid<std::uint16_t> mosaic(raw.rows(), raw.columns());
  for (std::size_t r = 0; r < raw.rows(); ++r)
    for (std::size_t c = 0; c < raw.columns(); ++c) mosaic(r, c) = raw(r, c)[r % 2 + c % 2];
  return mosaic;
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
  const auto header = texture::read_attributes(
      frame, std::array<std::string_view, 5>{pixel_attribute, sky_attribute, sky_place_attribute,
                                             disc_attribute, "coppermoon:version"});
  const auto number = [&](std::size_t place) {
    return std::max(0., algebra::number_in(header[place].value_or("")).value_or(0));
  };
  const bool holds_its_sky = header[2] == sky_place;
  return {number(0) * arcsec_rad, holds_its_sky ? number(1) : 0, outline_in(header[3].value_or("")),
          !header[4], holds_its_sky ? 0 : number(1)};
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

void require_raw_file(const std::filesystem::path& file, const colour::Camera& camera) {
  if (file.extension() != ".tif" && !is_dng(file))
    throw algebra::Error(fmt::format("{}: a raw file ends in .tif, or in .dng", file.string()));
  if (is_dng(file) && camera.sensor.response == "luminance")
    throw algebra::Error(
        fmt::format("{}: response = luminance, allowed for a raw file that ends in .dng a sensor "
                    "that sees colours",
                    file.string()));
}

void write_raw(const std::filesystem::path& file, const CameraRequest& request,
               const colour::Camera& camera, double iso, const colour::Photograph& photograph,
               const texture::Attributes& attributes) {
  require_raw_file(file, camera);
  if (!is_dng(file)) return texture::write_tiff(file, image_of(photograph.raw), attributes);
  const auto response = colour::response_named(camera.sensor.response);
  auto camera_from_xyz = response.from_xyz;
  for (int column = 0; column < 3; ++column) camera_from_xyz[column] *= response.sensitivity;
  const double black_dn = camera.sensor.black_level_dn;
  texture::write_dng(file,
                     {.numbers = mosaic_of(photograph.raw),
                      .black_dn = black_dn,
                      .white_dn = black_dn + colour::gain_at(camera, iso).white_dn,
                      .camera_from_xyz = camera_from_xyz,
                      .camera = request.model,
                      .focal_length_mm = camera.optics.focal_length_mm},
                     attributes);
}

}  // namespace coppermoon::uses
