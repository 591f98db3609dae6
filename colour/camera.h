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
  double focal_length_mm = 1540;  ///< allowed: 1 to 1e6
  double aperture_mm = 127;       ///< allowed: 0.1 to 1e5
  double obstruction = 0;         ///< diameter of the central obstruction / aperture, 0 to 0.9
  double transmission = 1;        ///< share of light that the glass transmits, 0.01 to 1
};

/// Image sensor.
struct Sensor {
  double width_mm = 22.7;  ///< allowed: 0.1 to 1000
  double pixel_um = 7.4;   ///< side of a pixel, 0.1 to 1000
  /// Electrons that white light frees in the most sensitive channel, divided by the number of photons in 555 nm light
  /// of the same luminance. Includes filters and fill factor; 0.001 to 1.
  double quantum_efficiency = 0.5;
  double full_well_e = 50000;     ///< electrons that a pixel can hold, 10 to 1e9
  double read_noise_e = 3;        ///< noise added before the amplifier [electrons], 0 to 1e4
  double converter_noise_dn = 1;  ///< noise added after the amplifier [DN], 0 to 1e4
  double black_level_dn = 0;      ///< raw number without light, 0 to half of the largest
  int bits = 14;                  ///< bits per raw number, 1 to 16
  std::string response = "colorimetric";
};

/// Everything between a scene and a raw file, except the exposure: optics, sensor and air.
struct Camera {
  CameraOptics optics{};
  Sensor sensor{};
  double seeing_arcsec = 0;  ///< full width at half maximum of a star's image, 0 to 600
  double glow = 0;           ///< share of the light that optics and air scatter widely, 0 to 0.5
  bool diffraction = true, noise = true;
};

/// Finds a camera in data/cameras.csv by name: paper, 400mm, schmidt-cassegrain or refractor.
///
/// Throws  Error  for any other name; the message lists the valid ones
Camera camera_named(std::string_view name);
std::vector<std::string> camera_names();

/// Response of a sensor's three channels to colour, as a matrix.
struct Response {
  glm::dmat3 from_xyz;     ///< from XYZ to the channels; D65 white gives 1, 1, 1
  glm::dvec3 sensitivity;  ///< sensitivity to white light, by channel; the largest is 1
};

/// Looks up a response by name: colorimetric (linear Rec.709 itself), luminance (a monochrome sensor), one from
/// data/camera_responses.csv, or a spectral one (camera_spectra.h). For a spectral response, `from_xyz` is the inverse
/// of the matrix that converts the camera's channels to XYZ, so that it recovers the channels from these XYZ values.
///
/// Throws  Error  for any other name, listing the valid ones; also when camera_spectra throws
Response response_named(const std::string& name);
std::vector<std::string> response_names();

/// Electrons that a pixel of the most sensitive channel collects under white light, per cd/m² of scene luminance.
///
///     QE · 4.09e15 s⁻¹ lm⁻¹ · L · π/4 τ (1 − ε²) / N² · t · p²
///
/// QE: quantum efficiency, L: luminance, τ: transmission, ε: obstruction, N: f-number, t: exposure time, p: pixel side.
/// One lumen is 4.09e15 photons of 555 nm per second.
///
/// Throws  Error  when a property of the camera or the exposure is outside its range
double electrons_per_cd_m2(const Camera& camera, const Exposure& exposure);

/// Gain of a sensor at an ISO speed.
struct Gain {
  double dn_per_electron;
  double white_dn;  ///< raw number of white minus the black level: whole, 1 to 65535
};

/// Gain at ISO speed S, at which an exposure of 78/S lx s fills the converter's range. White is at the top of this
/// range, or at full well if that is reached first.
///
/// Source  ISO 12232
/// Throws  Error  when the camera or the speed is outside its range, or white is less than 1 DN above black
Gain gain_at(const Camera& camera, double iso);

/// Luminance at which the camera saturates [cd/m²]: 1 / exposure_scale, but computed with the transmission of the
/// camera's own optics. It is lower if full well is reached first.
///
/// Throws  Error  as for electrons_per_cd_m2
double saturation_cd_m2(const Camera& camera, const Exposure& exposure);

/// Throws  Error  when a property of the camera is outside its range
void require_sound(const Camera& camera);

}  // namespace coppermoon::colour
