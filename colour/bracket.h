// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "algebra/grid.h"
#include "colour/display.h"

namespace coppermoon::colour {

/// Exposure of a bracketed set.
struct Bracketed {
  Image scene_linear;          ///< [cd/m²]
  algebra::Grid<float> valid;  ///< 1 where no channel is clipped, else 0
  double light = 1;            ///< weight: exposure time over f-number squared, in any unit
};

/// Luminance of the scene, from all exposures of a bracketed set.
///
///     L = Σ wᵢ Lᵢ / Σ wᵢ      wᵢ: `light`, where a pixel is valid
///
/// These weights minimise photon noise: Lᵢ has the variance L / wᵢ.
///
/// Given     photographs  of one size; light above 0
/// Returned  valid where any photograph is; elsewhere scene_linear is that of the shortest exposure, at its
///           saturation. light: the sum of all
/// Omits     read noise, for which the dark of a short exposure should weigh less
/// Throws    Error  when there is none, sizes differ, or a light is not above 0
Bracketed merged(std::span<const Bracketed> photographs);

}  // namespace coppermoon::colour
