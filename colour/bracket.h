// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "algebra/grid.h"
#include "colour/display.h"

namespace coppermoon::colour {

/// One exposure in a bracketed set.
struct Bracketed {
  Image scene_linear;          ///< [cd/m²]
  algebra::Grid<float> valid;  ///< 1 where no channel is clipped, else 0
  double light = 1;            ///< weight: exposure time divided by f-number squared, any unit
};

/// Luminance of the scene, merged from all exposures in a bracketed set.
///
///     L = Σ wᵢ Lᵢ / Σ wᵢ      wᵢ: `light` if the pixel is valid, else 0
///
/// These weights minimise photon noise, because the variance of Lᵢ is L / wᵢ.
///
/// Given     photographs  all of the same size; light above 0
/// Returned  pixels are valid if they are valid in any photograph. Elsewhere scene_linear comes from the shortest
///           exposure, which is saturated there. `light` is the sum over all photographs
/// Omits     read noise, which would give less weight to the dark parts of short exposures
/// Throws    Error  when there is no photograph, their sizes differ, or a `light` is not above 0
Bracketed merged(std::span<const Bracketed> photographs);

}  // namespace coppermoon::colour
