// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "algebra/grid.h"
#include "colour/camera.h"
#include "colour/display.h"
#include "colour/working_space.h"

namespace coppermoon::colour {

/// One release of the shutter.
struct Shot {
  Exposure exposure{};
  double pixel_rad = 1e-5;  ///< angle across a pixel of the scene's frame
  double sky_cd_m2 = 0;     ///< luminance of the sky, white as D65; 0 or more
  std::uint64_t seed = 1, frame = 0;
};

using RawPixel = std::array<std::uint16_t, 3>;

/// Photograph, developed and raw.
struct Photograph {
  /// Luminances with the camera's noise, also below 0; clipped pixels are white at saturation.
  Image scene_linear;
  algebra::Grid<float> valid;   ///< 1 below nine tenths of saturation in each channel, else 0
  algebra::Grid<RawPixel> raw;  ///< black level included [DN]; red, green, blue of every pixel
  double saturation_cd_m2 = 0;  ///< of white
};

/// Simulated photograph of a scene.
///
/// Light is spread by aperture and air, near its place and far (glow.h), the sky's added, and turned into electrons by
/// the sensor's response: with noise, as many as a Poisson process sets free. A pixel holds no more than its full
/// well; amplifier and converter add their noise; whole numbers of as many bits come out, cut off at
/// either end. Developed, no channel is above what white has where the most sensitive one saturates.
///
/// A frame's pixel that takes in n of the sensor's (or a part of one) stands for them: their mean,
/// with n times the electrons.
///
/// Given     scene_linear  [cd/m²] of the working space, finite
/// Returned  the same for the same seed and frame, whatever the number of threads
/// Omits     glow of what is beyond the frame; the mosaic of colour filters (every pixel has three
///           channels), dark current, banding, dust, reflections
/// Throws    Error         when a pixel is not finite, or camera, exposure, pixel or sky is outside its
///                         range
Photograph photographed(const Image& scene_linear, WorkingSpace space, const Camera& camera,
                        const Shot& shot);

}  // namespace coppermoon::colour
