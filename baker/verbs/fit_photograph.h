// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "algebra/grid.h"
#include "almanac/sky.h"
#include "colour/registration.h"
#include "texture/image.h"
#include "verbs/fit_light.h"
#include "verbs/moon_options.h"
#include "verbs/observer_options.h"

namespace coppermoon::verbs {

/// The Moon of one moment as a place on Earth sees it: what photographs of it are held against.
struct FitScene {
  algebra::Grid<float> sunlit;   ///< a small picture, without the shadow; 1: a white ground at 1 au
  algebra::Grid<float> usual;    ///< luminance under the usual air, to be recognised by
  std::vector<LitPlace> places;  ///< of pixels well within the disc, by step of axis distance
  std::vector<std::size_t> pixels;  ///< of those places: row × columns + column
  std::size_t bins = 0;
  std::optional<FittedLight> light{};  ///< XYZ
};

/// Given   moon  its light's air is all that is not sought
/// Throws  Error as lit_scene
FitScene fit_scene(const MoonOptions& moon, const ViewOptions& view);

/// A photograph's light over a scene's bins.
struct BinnedPhotograph {
  algebra::Grid<double>
      values;  ///< (bin, channel), linear Rec.709: light over sunlit; 0: not known
  algebra::Grid<double> errors;  ///< standard, by their scatter; as far as neighbours are apart
  colour::Registration registration{};
};

/// Registers a photograph; what is clipped, and with it the bin that it is half a hundredth of, is left
/// out. The sky's light, beside the disc, is taken off.
///
/// Given   photo  linear, 1 saturates
/// Throws  Error  as colour::registered
BinnedPhotograph binned(const FitScene& scene, const texture::Image& photo);

}  // namespace coppermoon::verbs
