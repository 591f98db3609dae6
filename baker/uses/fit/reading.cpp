// SPDX-License-Identifier: MIT
#include "uses/fit/reading.h"

#include "colour/camera.h"
#include "colour/camera_spectra.h"
#include "colour/exposure.h"
#include "uses/picture/as_shot_balance.h"

namespace coppermoon::uses {
namespace {

/// Whether a picture has only shades of grey, like one from a camera without colour filters.
bool is_grey(const texture::Image& photo) {
  for (std::size_t i = 0; i < photo.values.size(); i += 3)
    if (photo.values[i] != photo.values[i + 1] || photo.values[i] != photo.values[i + 2])
      return false;
  return true;
}

/// Exposure of a photograph. Each setting comes from the request, else from the header; nothing if one is missing. If
/// the exposures of a night share an unknown factor (`free`), a constant replaces a missing f-number, and another one
/// replaces a missing ISO speed if the header states a gain.
std::optional<colour::Exposure> exposure_of(const EclipsePhotograph& photograph,
                                            const CameraSettings& header, bool free) {
  const auto time_s = photograph.time_s ? photograph.time_s : header.time_s;
  auto iso = photograph.iso ? photograph.iso : header.iso,
       f_number = photograph.f_number ? photograph.f_number : header.f_number;
  if (free && !f_number) f_number = 8;
  if (free && !iso && header.gain) iso = 100;
  if (!time_s || !iso || !f_number) return std::nullopt;
  return colour::Exposure{*time_s, *f_number, *iso};
}

PhotometricErrors errors_of(const FitRequest& request, const EclipsePhotograph& photograph,
                            const Reading& reading, bool as_shot) {
  constexpr double of_automatic_white_balance = 0.3, of_known_colours = 0.03;
  constexpr double of_as_shot = 0.06, of_as_shot_by_another = 0.2, as_shot_drift = 0.02;
  constexpr double of_weather = 0.2;
  constexpr double of_shutter = 0.03, of_brightness = 0.1;
  constexpr double of_exposures = 0.1, free = 10;
  const bool curved = reading.curved, raw = texture::is_raw_file(photograph.file);
  const auto header = settings_of(photograph.file);
  // sensor counts, or a gain instead of an ISO speed, give the light only up to a common factor
  const bool relative = reading.clipped_at || (header.gain && !photograph.iso && !header.iso);
  PhotometricErrors errors{
      .exposure_error = request.exposure_error.value_or(curved || relative ? free : of_exposures),
      .shutter_error = request.shutter_error.value_or(curved ? of_brightness : of_shutter),
      .white_balance_error =
          request.white_balance_error.value_or(!curved    ? of_known_colours
                                               : !as_shot ? of_automatic_white_balance
                                               : request.response_assumed ? of_as_shot_by_another
                                                                          : of_as_shot),
      .white_balance_shared = as_shot || white_balance_is_fixed(photograph.file),
      .weather_error = request.weather_error.value_or(curved || raw ? of_weather : 0)};
  // a camera's colour matrix is wrong by a few per cent, except for raw files of cameras with known filters
  if (curved || (raw && !request.moon.response)) errors.mixing_error = 0.03;
  if (as_shot) errors.white_balance_drift = as_shot_drift;
  if (curved) errors.dark_error = 0.02;       // error of the light added to dark channels
  if (curved) errors.saturation_error = 0.2;  // JPEG styles scale saturation by 0.8 to 1.3
  if (const auto exposure = exposure_of(photograph, header, errors.exposure_error >= free))
    errors.value_per_cd_m2 =
        (request.camera.empty()
             ? colour::exposure_scale(*exposure)
             : 1 / colour::saturation_cd_m2(colour::camera_named(request.camera), *exposure)) /
        (reading.clipped_at ? reading.clipped_at->light : 1);
  return errors;
}

}  // namespace

/// Levels that count as clipped: for pictures coded for a display, most of which compress highlights above this level,
/// and for linear light.
constexpr float shoulder = 0.75F, linear = 0.97F;

bool is_edited(const EclipsePhotograph& photograph) {
  return photograph.coding == texture::Coding::as_file_says && editor_of(photograph.file);
}

bool is_curved(const EclipsePhotograph& photograph) {
  return is_edited(photograph) ||
         coding_of(photograph.file, photograph.coding) == texture::Coding::camera;
}

Reading reading_of(const FitRequest& request, const EclipsePhotograph& photograph) {
  Reading reading;
  try {
    reading.edited = is_edited(photograph);
    reading.curved = is_curved(photograph);
    auto photo = photo_light(photograph.file, photograph.coding, request.moon.response);
    reading.extent = {photo.width, photo.height};
    reading.clipped_at = clipped_at(photograph.file, photo);
    if (reading.clipped_at)
      for (float& value : photo.values) value /= static_cast<float>(reading.clipped_at->light);
    reading.moon =
        moon_part(photo, reading.curved ? static_cast<float>(colour::most_displayed)
                         : is_display_coded(photograph.file, photograph.coding) ? shoulder
                                                                                : linear);
    if (is_grey(photo))
      throw algebra::Error("shades of grey, allowed are colours: red, green and blue");
    // the camera's white-balance gains are useful only if the spectral response of its channels is known
    const bool spectral = request.moon.response && colour::is_spectral(*request.moon.response);
    const auto as_shot =
        reading.curved && spectral ? as_shot_balance(photograph.file) : std::nullopt;
    if (reading.curved) reading.colours = camera_colours(request.moon.response, as_shot);
    reading.errors = errors_of(request, photograph, reading, as_shot.has_value());
  } catch (const algebra::Error& error) {
    reading.left_out = reason_without_name(photograph.file, error);
  }
  return reading;
}

}  // namespace coppermoon::uses
