// SPDX-License-Identifier: MIT
#include "verbs/develop_options.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "algebra/error.h"
#include "algebra/number.h"
#include "colour/display.h"
#include "texture/write_image.h"
#include "verbs/pixels.h"

namespace coppermoon::verbs {
namespace {

double seconds_from(const std::string& text) {
  const auto seconds = algebra::number_in(text);
  if (!seconds)
    throw algebra::Error(
        fmt::format("exposure time = {}, allowed auto, follow or 1e-6 to 1e6 s", text));
  return *seconds;
}

bool by_the_frame(const DevelopOptions& options) {
  return options.time == "auto" || options.time == "follow";
}

/// Of all lit pixels.
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

std::optional<colour::Camera> camera_of(const DevelopOptions& options) {
  return camera_of(options.camera, options.f_number, options.focal_length_mm);
}

double f_number_of(const DevelopOptions& options) {
  const auto camera = camera_of(options);
  return camera ? camera->optics.focal_length_mm / camera->optics.aperture_mm
                : options.f_number.value_or(12.1);
}

void require_ending(const std::string& file, const char* what, const char* ending) {
  if (!file.empty() && std::filesystem::path(file).extension() != ending)
    throw algebra::Error(fmt::format("{}: {} ends in {}", file, what, ending));
}

void write_files(const CameraOptions& camera, const colour::Photograph& photograph,
                 const colour::Exposure& exposure, texture::Attributes attributes) {
  add_exposure(attributes, exposure);
  if (!camera.raw.empty()) texture::write_tiff(camera.raw, image_of(photograph.raw), attributes);
  attributes["coppermoon:saturation_cd_m2"] = static_cast<float>(photograph.saturation_cd_m2);
  if (!camera.photograph.empty())
    texture::write_exr(camera.photograph, image_of(photograph.scene_linear, photograph.valid),
                       attributes, {.type = texture::ExrType::floating, .allow_negative = true});
}

}  // namespace

void add_develop_options(CLI::App& verb, DevelopOptions& options) {
  const std::string group = camera_group;
  add_flag(verb, "--time", options.time,
           "exposure time [s]; auto: the brightest are not lost; follow: as the shadow deepens, "
           "without a step")
      .in(group);
  add_flag(verb, "--f-number", options.f_number,
           "focal length over aperture; 12.1, or the camera's")
      .in(group);
  add_flag(verb, "--iso", options.iso, "ISO 12232 saturation-based speed").in(group);
  add_flag(verb, "--view", options.view, "of the OpenColorIO configuration").in(group);
  add_flag(verb, "--display", options.display, "of the OpenColorIO configuration").in(group);
  add_flag(verb, "--config", options.config,
           "an OpenColorIO configuration instead of the built-in one")
      .reads_file()
      .in(group);
  add_flag(verb, "--bits", options.bits, "of the picture, 8 or 16").one_of({"8", "16"}).in(group);
}

colour::Exposure exposure_for(const DevelopOptions& options, const texture::Image& frame,
                              colour::WorkingSpace space) {
  constexpr double brightest = 0.8, followed = 0.25;
  colour::Exposure exposure{1, f_number_of(options), options.iso};
  if (!by_the_frame(options)) {
    exposure.time_s = seconds_from(options.time);
  } else if (const auto lit = luminances(frame, space); !lit.empty()) {
    const double scaled =
        options.time == "auto" ? brightest / bright_luminance(lit) : followed / cubic_mean(lit);
    exposure.time_s = std::clamp(scaled / scale_of(options, exposure), 1e-6, 1e5);
  }
  return exposure;
}

double scale_of(const DevelopOptions& options, const colour::Exposure& exposure) {
  const auto camera = camera_of(options);
  return camera ? 1 / colour::saturation_cd_m2(*camera, exposure)
                : colour::exposure_scale(exposure);
}

texture::Image taken(const DevelopOptions& options, const colour::Exposure& exposure,
                     const texture::Image& frame, colour::WorkingSpace space, const Seen& seen,
                     std::uint64_t number, const texture::Attributes& attributes) {
  const auto camera = camera_of(options);
  if (!camera) return frame;
  const auto photograph =
      photographed(options.camera, *camera, pixels_of(frame), space, seen, exposure, number);
  write_files(options.camera, photograph, exposure, attributes);
  return image_of(photograph.scene_linear);
}

void add_exposure(texture::Attributes& attributes, const colour::Exposure& exposure) {
  attributes["expTime"] = static_cast<float>(exposure.time_s);
  attributes["aperture"] = static_cast<float>(exposure.f_number);
  attributes["isoSpeed"] = static_cast<float>(exposure.iso);
}

void require_sound(const DevelopOptions& options, const std::filesystem::path& picture) {
  if (picture.extension() != ".png")
    throw algebra::Error(fmt::format("{}: a picture ends in .png", picture.string()));
  require_ending(options.camera.raw, "a raw file", ".tif");
  require_ending(options.camera.photograph, "a photograph", ".exr");
  colour::exposure_scale(
      {by_the_frame(options) ? 1 : seconds_from(options.time), f_number_of(options), options.iso});
  if (const auto camera = camera_of(options)) colour::gain_at(*camera, options.iso);
  const auto views = colour::views(options.display, options.config);
  if (std::find(views.begin(), views.end(), options.view) == views.end())
    throw algebra::Error(
        fmt::format("view = {}, allowed {}", options.view, fmt::join(views, ", ")));
}

std::string fingerprint(const DevelopOptions& options, colour::WorkingSpace space) {
  return colour::fingerprint(space, {1, options.view, options.display, options.config});
}

texture::Image shown(const DevelopOptions& options, double scale, const texture::Image& frame,
                     colour::WorkingSpace space) {
  const auto pixels = colour::developed(pixels_of(frame), space,
                                        {scale, options.view, options.display, options.config});
  auto image = image_of(pixels);
  for (float& value : image.values) value = std::clamp(value, 0.F, 1.F);
  return image;
}

texture::Image developed(const DevelopOptions& options, const colour::Exposure& exposure,
                         const texture::Image& frame, colour::WorkingSpace space) {
  return shown(options, scale_of(options, exposure), frame, space);
}

void write_developed(const DevelopOptions& options, const colour::Exposure& exposure,
                     const texture::Image& frame, colour::WorkingSpace space,
                     const std::filesystem::path& picture, texture::Attributes attributes) {
  const auto image = developed(options, exposure, frame, space);
  attributes["coppermoon:view"] = options.display + ", " + options.view;
  add_exposure(attributes, exposure);
  texture::write_png(picture, image, options.bits, attributes);
}

}  // namespace coppermoon::verbs
