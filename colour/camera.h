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

/// A telescope or a lens, focused on the Moon.
struct CameraOptics {
  double focal_length_mm = 1540;  ///< 1 to 1e6
  double aperture_mm = 127;       ///< 0.1 to 1e5; what the f-number says
  double obstruction = 0;         ///< diameter of the secondary over the aperture's, 0 to 0.9
  double transmission = 1;        ///< of the glass, 0.01 to 1
};

/// The sensor in its focus.
struct Sensor {
  double width_mm = 22.7;  ///< 0.1 to 1000
  double pixel_um = 7.4;   ///< a pixel's side, 0.1 to 1000
  /// electrons of the most sensitive channel under white light, per equal-luminance photon of 555 nm,
  /// filters and fill factor included; 0.001 to 1
  double quantum_efficiency = 0.5;
  double full_well_e = 50000;     ///< 10 to 1e9
  double read_noise_e = 3;        ///< before the gain, 0 to 1e4
  double converter_noise_dn = 1;  ///< behind it, 0 to 1e4
  double black_level_dn = 0;      ///< 0 to half of what the bits hold
  int bits = 14;                  ///< 1 to 16
  std::string response = "colorimetric";
};

/// A camera: all that is between a scene and a raw file, without its exposure.
struct Camera {
  CameraOptics optics{};
  Sensor sensor{};
  double seeing_arcsec = 0;  ///< full width at half maximum of a star, 0 to 600
  double glow = 0;           ///< share of the light that optics and air spread far, 0 to 0.5
  bool diffraction = true, noise = true;
};

/// A camera by name, of data/cameras.csv: paper, 400mm, schmidt-cassegrain, refractor.
///
/// Throws  Error  when there is none: names those there are
Camera camera_named(std::string_view name);
std::vector<std::string> camera_names();

/// How a sensor's channels see colour.
struct Response {
  glm::dmat3 from_xyz;     ///< to channels that see D65's white as 1, 1, 1
  glm::dvec3 sensitivity;  ///< of each before it is balanced so, the largest 1: green's
};

/// colorimetric: linear Rec.709 itself; luminance: a sensor without colours; or of
/// data/camera_responses.csv.
///
/// Throws  Error  when there is none: names those there are
Response response_named(std::string_view name);
std::vector<std::string> response_names();

/// Electrons that a pixel of the most sensitive channel collects under white light, for each cd/m².
///
///     QE · 4.09e15 s⁻¹ lm⁻¹ · L · π/4 τ (1 − ε²) / N² · t · p²
///
/// 4.09e15 photons of 555 nm a second are one lumen.
///
/// Returned  for each cd/m²
/// Throws    Error  when camera or exposure is outside its range
double electrons_per_cd_m2(const Camera& camera, const Exposure& exposure);

/// The numbers that a sensor gives at a speed.
struct Gain {
  double dn_per_electron;
  double white_dn;  ///< above the black level, whole; 1 to 65535
};

/// Gain at the speed S: the electrons of 78/S lx s fill the range of the numbers. White is at its
/// end, or lower where pixels are full before.
///
/// Source  ISO 12232
/// Throws  Error  when camera or speed is outside its range, or white is not one number above black
Gain gain_at(const Camera& camera, double iso);

/// Luminance that becomes the camera's white [cd/m²]: as colour::exposure_scale has it, with the
/// optics' own transmission in place of a usual lens's; lower where a pixel is full before.
///
/// Throws  Error  as electrons_per_cd_m2
double saturation_cd_m2(const Camera& camera, const Exposure& exposure);

/// Throws  Error  when anything of it is outside its range
void require_sound(const Camera& camera);

}  // namespace coppermoon::colour
