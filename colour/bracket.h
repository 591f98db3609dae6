// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "algebra/grid.h"
#include "colour/display.h"

namespace coppermoon::colour {

/// One of several photographs of a scene that holds still.
struct Bracketed {
  Image scene_linear;          ///< [cd/m²]
  algebra::Grid<float> valid;  ///< 1 where no channel is clipped, else 0
  double light = 1;  ///< electrons for each cd/m², in any unit: time over f-number squared
};

/// The scene's luminance from a bracketed set.
///
///     L = Σ wᵢ Lᵢ / Σ wᵢ      wᵢ: the light, where a pixel is valid
///
/// Photons' noise is least so: Lᵢ has the variance L / wᵢ.
///
/// Given     photographs  of one size; light above 0
/// Returned  scene_linear, valid where any is; elsewhere that of the photograph with least light, at
///           its saturation. light: the sum of all
/// Omits     read noise, which weighs down a short exposure's dark more than this does
/// Throws    Error  when there is none, sizes differ, or a light is not above 0
Bracketed merged(std::span<const Bracketed> photographs);

}  // namespace coppermoon::colour
