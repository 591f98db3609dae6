// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "colour/exposure.h"

namespace coppermoon::colour {

/// A telescope or lens focused on the Moon.
struct CameraOptics {
  double focal_length_mm = 1540;  ///< 1 to 1e6
  double aperture_mm = 127;       ///< 0.1 to 1e5
  double obstruction = 0;         ///< central obstruction, diameter over aperture: 0 to 0.9
  double transmission = 1;        ///< of the glass, 0.01 to 1
};

/// Image sensor.
struct Sensor {
  double width_mm = 22.7;  ///< 0.1 to 1000
  double pixel_um = 7.4;   ///< a pixel's side, 0.1 to 1000
  /// Electrons in the most sensitive channel under white light, per 555 nm photon in green light of the same
  /// luminance; filters and fill factor included; 0.001 to 1.
  double quantum_efficiency = 0.5;
  double full_well_e = 50000;     ///< 10 to 1e9
  double read_noise_e = 3;        ///< before the amplifier, 0 to 1e4
  double converter_noise_dn = 1;  ///< after the amplifier, 0 to 1e4
  double black_level_dn = 0;      ///< 0 to half of the largest number
  int bits = 14;                  ///< 1 to 16
  std::string response = "colorimetric";
};

/// Everything between a scene and a raw file, except the exposure: optics, sensor and air.
struct Camera {
  CameraOptics optics{};
  Sensor sensor{};
  double seeing_arcsec = 0;  ///< full width at half maximum of a star, 0 to 600
  double glow = 0;           ///< share of the light that optics and air scatter widely, 0 to 0.5
  bool diffraction = true, noise = true;
};

/// A camera from data/cameras.csv: paper, 400mm, schmidt-cassegrain, refractor.
///
/// Throws  Error  for any other name; the message lists the valid ones
Camera camera_named(std::string_view name);
std::vector<std::string> camera_names();

/// Response of a sensor's channels, as a matrix.
struct Response {
  glm::dmat3 from_xyz;     ///< to channels that are 1, 1, 1 for D65
  glm::dvec3 sensitivity;  ///< of each channel before white balance; the largest is 1
};

/// Looks up a response by name: colorimetric (linear Rec.709 itself), luminance (a monochrome sensor), one from
/// data/camera_responses.csv, or a spectral one (camera_spectra.h). A spectral response's matrix is the inverse of the
/// one that turns the camera's channels into colours, so that light seen by the camera becomes its channels again.
///
/// Throws  Error  for any other name, listing the valid ones; as camera_spectra
Response response_named(const std::string& name);
std::vector<std::string> response_names();

/// Electrons that a pixel of the most sensitive channel collects under white light, per cd/m².
///
///     QE · 4.09e15 s⁻¹ lm⁻¹ · L · π/4 τ (1 − ε²) / N² · t · p²
///
/// One lumen is 4.09e15 photons of 555 nm per second.
///
/// Throws  Error  when camera or exposure is outside its range
double electrons_per_cd_m2(const Camera& camera, const Exposure& exposure);

/// Gain of a sensor at an ISO speed.
struct Gain {
  double dn_per_electron;
  double white_dn;  ///< above the black level, a whole number; 1 to 65535
};

/// Gain at ISO speed S: an exposure of 78/S lx s fills the converter's range. White is at the end of
/// that range, or at full well if that is lower.
///
/// Source  ISO 12232
/// Throws  Error  when camera or speed is outside its range, or white is not at least 1 DN above black
Gain gain_at(const Camera& camera, double iso);

/// Luminance at which the camera saturates [cd/m²]: as in exposure_scale, but with the optics' own transmission;
/// lower if full well comes first.
///
/// Throws  Error  as electrons_per_cd_m2
double saturation_cd_m2(const Camera& camera, const Exposure& exposure);

/// Refuses a camera with a number outside its range.
///
/// Throws  Error
void require_sound(const Camera& camera);

}  // namespace coppermoon::colour
