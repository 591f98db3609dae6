// SPDX-License-Identifier: MIT
#include "uses/picture/development.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "algebra/error.h"
#include "colour/display.h"
#include "texture/write_image.h"
#include "uses/picture/pixels.h"

namespace coppermoon::uses {
namespace {

/// Luminances of all lit pixels [cd/m²].
std::vector<double> luminances(const texture::Image& frame, colour::WorkingSpace space) {
  std::vector<double> lit;
  const auto pixels = pixels_of(frame);
  for (const auto& [red, green, blue] : pixels.values()) {
    const std::array<double, 3> pixel{red, green, blue};
    if (const double y = colour::luminance(space, pixel); y > 0) lit.push_back(y);
  }
  return lit;
}

/// Luminance above which a hundredth of them are.
double bright_luminance(std::vector<double> lit) {
  const auto bright = lit.begin() + static_cast<std::ptrdiff_t>(lit.size() * 99 / 100);
  std::nth_element(lit.begin(), bright, lit.end());
  return *bright;
}

/// The cube of their cube roots' mean: as the shadow creeps over the disc it leaves sunlight's for the
/// shadow's without a step.
double cubic_mean(std::span<const double> lit) {
  double roots = 0;
  for (const double y : lit) roots += std::cbrt(y);
  const double mean = roots / static_cast<double>(lit.size());
  return mean * mean * mean;
}

std::optional<colour::Camera> camera_of(const Development& development) {
  return camera_of(development.camera, development.f_number, development.focal_length_mm);
}

double f_number_of(const Development& development) {
  const auto camera = camera_of(development);
  return camera ? camera->optics.focal_length_mm / camera->optics.aperture_mm
                : development.f_number.value_or(12.1);
}

void require_ending(const std::filesystem::path& file, const char* what, const char* ending) {
  if (!file.empty() && file.extension() != ending)
    throw algebra::Error(fmt::format("{}: {} ends in {}", file.string(), what, ending));
}

void write_files(const CameraRequest& camera, const colour::Photograph& photograph,
                 const colour::Exposure& exposure, texture::Attributes attributes) {
  add_exposure(attributes, exposure);
  if (!camera.raw.empty()) texture::write_tiff(camera.raw, image_of(photograph.raw), attributes);
  attributes["coppermoon:saturation_cd_m2"] = static_cast<float>(photograph.saturation_cd_m2);
  if (!camera.photograph.empty())
    texture::write_exr(camera.photograph, image_of(photograph.scene_linear, photograph.valid),
                       attributes, {.type = texture::ExrType::floating, .allow_negative = true});
}

}  // namespace

colour::Exposure exposure_for(const Development& development, const texture::Image& frame,
                              colour::WorkingSpace space) {
  constexpr double brightest = 0.8, followed = 0.25;
  colour::Exposure exposure{1, f_number_of(development), development.iso};
  if (development.time.rule == ExposureTime::Rule::fixed) {
    exposure.time_s = development.time.seconds;
  } else if (const auto lit = luminances(frame, space); !lit.empty()) {
    const double scaled = development.time.rule == ExposureTime::Rule::automatic
                              ? brightest / bright_luminance(lit)
                              : followed / cubic_mean(lit);
    exposure.time_s = std::clamp(scaled / scale_of(development, exposure), 1e-6, 1e5);
  }
  return exposure;
}

double scale_of(const Development& development, const colour::Exposure& exposure) {
  const auto camera = camera_of(development);
  return camera ? 1 / colour::saturation_cd_m2(*camera, exposure)
                : colour::exposure_scale(exposure);
}

texture::Image taken(const Development& development, const colour::Exposure& exposure,
                     const Frame& frame) {
  const auto camera = camera_of(development);
  if (!camera) return frame.light;
  const auto photograph = photographed(development.camera, *camera, frame, exposure);
  write_files(development.camera, photograph, exposure, frame.attributes);
  return image_of(photograph.scene_linear);
}

void add_exposure(texture::Attributes& attributes, const colour::Exposure& exposure) {
  attributes["expTime"] = static_cast<float>(exposure.time_s);
  attributes["aperture"] = static_cast<float>(exposure.f_number);
  attributes["isoSpeed"] = static_cast<float>(exposure.iso);
}

void require_sound(const Development& development, const std::filesystem::path& picture) {
  if (picture.extension() != ".png")
    throw algebra::Error(fmt::format("{}: a picture ends in .png", picture.string()));
  require_ending(development.camera.raw, "a raw file", ".tif");
  require_ending(development.camera.photograph, "a photograph", ".exr");
  colour::exposure_scale({development.time.seconds, f_number_of(development), development.iso});
  if (const auto camera = camera_of(development)) colour::gain_at(*camera, development.iso);
  const auto views = colour::views(development.display, development.config);
  if (std::find(views.begin(), views.end(), development.view) == views.end())
    throw algebra::Error(
        fmt::format("view = {}, allowed {}", development.view, fmt::join(views, ", ")));
}

std::string fingerprint(const Development& development, colour::WorkingSpace space) {
  return colour::fingerprint(space, {1, development.view, development.display, development.config});
}

texture::Image shown(const Development& development, double scale, const texture::Image& frame,
                     colour::WorkingSpace space) {
  const auto pixels = colour::developed(
      pixels_of(frame), space, {scale, development.view, development.display, development.config});
  auto image = image_of(pixels);
  for (float& value : image.values) value = std::clamp(value, 0.F, 1.F);
  return image;
}

texture::Image developed(const Development& development, const colour::Exposure& exposure,
                         const texture::Image& frame, colour::WorkingSpace space) {
  return shown(development, scale_of(development, exposure), frame, space);
}

void write_developed(const Development& development, const colour::Exposure& exposure,
                     const Frame& frame, const std::filesystem::path& picture) {
  const auto image = developed(development, exposure, frame.light, frame.space);
  auto attributes = frame.attributes;
  attributes["coppermoon:view"] = development.display + ", " + development.view;
  add_exposure(attributes, exposure);
  texture::write_png(picture, image, development.bits, attributes);
}

}  // namespace coppermoon::uses
