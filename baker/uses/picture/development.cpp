// SPDX-License-Identifier: MIT
#include "uses/picture/development.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
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

/// A luminance's leading bits, which are in its order; and the middle of all that share them.
constexpr unsigned dropped_bits = 12;

std::size_t step_of(double luminance) {
  return std::bit_cast<std::uint32_t>(static_cast<float>(luminance)) >> dropped_bits;
}

double middle_of(std::size_t step) {
  const auto half = std::uint32_t{1} << (dropped_bits - 1);
  return std::bit_cast<float>((static_cast<std::uint32_t>(step) << dropped_bits) | half);
}

/// The cube of their cube roots' mean: as the shadow creeps over the disc it leaves sunlight's for the
/// shadow's without a step.
double cubic_mean(double roots, std::size_t count) {
  const double mean = roots / static_cast<double>(count);
  return mean * mean * mean;
}

double cube_roots(std::span<const double> lit) {
  double roots = 0;
  for (const double y : lit) roots += std::cbrt(y);
  return roots;
}

/// That brings a frame's bright luminance, or the cubic mean where it is followed, to where it should be.
colour::Exposure exposed_for(const Development& development, colour::Exposure exposure,
                             double luminance) {
  constexpr double brightest = 0.8, followed = 0.25;
  const bool automatic = development.time.rule == ExposureTime::Rule::automatic;
  const double scaled = (automatic ? brightest : followed) / luminance;
  exposure.time_s = std::clamp(scaled / scale_of(development, exposure), 1e-6, 1e5);
  return exposure;
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
  const colour::Exposure one{1, f_number_of(development), development.iso};
  if (development.time.rule == ExposureTime::Rule::fixed)
    return {development.time.seconds, one.f_number, one.iso};
  const auto lit = luminances(frame, space);
  if (lit.empty()) return one;
  return exposed_for(development, one,
                     development.time.rule == ExposureTime::Rule::automatic
                         ? bright_luminance(lit)
                         : cubic_mean(cube_roots(lit), lit.size()));
}

SharedExposure::SharedExposure(const Development& development) : development_(development) {
  if (development.time.rule == ExposureTime::Rule::automatic)
    counts_.resize(std::size_t{1} << (32 - dropped_bits));
}

void SharedExposure::add(const texture::Image& frame, colour::WorkingSpace space) {
  if (development_.time.rule == ExposureTime::Rule::fixed) return;
  const auto lit = luminances(frame, space);
  lit_ += lit.size();
  if (counts_.empty())
    cube_roots_ += cube_roots(lit);
  else
    for (const double y : lit) ++counts_[step_of(y)];
}

colour::Exposure SharedExposure::exposure() const {
  const colour::Exposure one{1, f_number_of(development_), development_.iso};
  if (development_.time.rule == ExposureTime::Rule::fixed)
    return {development_.time.seconds, one.f_number, one.iso};
  if (lit_ == 0) return one;
  if (counts_.empty()) return exposed_for(development_, one, cubic_mean(cube_roots_, lit_));
  std::size_t step = 0;
  for (std::size_t below = counts_[0]; below <= lit_ * 99 / 100;) below += counts_[++step];
  return exposed_for(development_, one, middle_of(step));
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
