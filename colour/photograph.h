// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "algebra/grid.h"
#include "colour/camera.h"
#include "colour/display.h"
#include "colour/working_space.h"

namespace coppermoon::colour {

/// One shot: camera settings, scale of the scene, and sky.
struct Shot {
  Exposure exposure{};
  double pixel_rad = 1e-5;  ///< angle that a pixel of the scene's frame covers
  double sky_cd_m2 = 0;     ///< luminance of the sky, which is as white as D65; 0 or more
  std::uint64_t seed = 1, frame = 0;
};

using RawPixel = std::array<std::uint16_t, 3>;

/// A photograph, both developed and raw.
struct Photograph {
  /// Luminances [cd/m²] with the camera's noise, which makes some negative. Clipped pixels are white, at saturation.
  Image scene_linear;
  algebra::Grid<float> valid;   ///< 1 if every channel is below nine tenths of saturation, else 0
  algebra::Grid<RawPixel> raw;  ///< red, green and blue of each pixel, black level included [DN]
  double saturation_cd_m2 = 0;  ///< luminance at which white saturates
};

/// Simulates a photograph of a scene.
///
/// The aperture and the air spread light, both nearby and far (see glow.h), and the sky adds light. The sensor's
/// response turns light into electrons, with Poisson noise if noise is on. A pixel holds no more than its full well.
/// Amplifier and converter add their noise. Raw values are whole numbers of the sensor's bit depth, clipped at both
/// ends. In the developed picture, no channel exceeds white at the saturation of the most sensitive channel.
///
/// A pixel of the frame may cover several of the sensor's pixels, or part of one. If it covers n of them, it gets their
/// mean value, which comes from n times the electrons.
///
/// Given     scene_linear  channels of the working space [cd/m²], finite
/// Returned  a photograph that is the same for the same seed and frame, whatever the number of threads
/// Omits     glow from beyond the frame; the mosaic of colour filters (every pixel has three channels), dark current,
///           banding, dust, reflections
/// Throws    Error         when a pixel is not finite, or the camera, exposure, pixel size or sky is outside its range
Photograph photographed(const Image& scene_linear, WorkingSpace space, const Camera& camera,
                        const Shot& shot);

}  // namespace coppermoon::colour
