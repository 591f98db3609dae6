// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "algebra/grid.h"
#include "colour/display.h"

namespace coppermoon::colour {

/// One exposure in a bracketed set.
struct Bracketed {
  Image scene_linear;          ///< luminances [cd/m²]
  algebra::Grid<float> valid;  ///< 1 at pixels with no clipped channel, else 0
  double light = 1;            ///< weight: exposure time divided by f-number squared, in any unit
};

/// Luminance of the scene, merged from all exposures in a bracketed set.
///
///     L = Σ wᵢ Lᵢ / Σ wᵢ      wᵢ: `light` if the pixel is valid, else 0
///
/// These weights minimise photon noise, because the variance of Lᵢ is proportional to L / wᵢ.
///
/// Given     photographs  all of the same size; each `light` above 0
/// Returned  a photograph in which pixels are valid if they are valid in any photograph. Other pixels are those of the
///           shortest exposure, in which they are saturated. `light` is the sum over all photographs
/// Omits     read noise, which would give less weight to the dark parts of short exposures
/// Throws    Error  when there is no photograph, their sizes differ, or a `light` is not above 0
Bracketed merged(std::span<const Bracketed> photographs);

}  // namespace coppermoon::colour
