// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "algebra/grid.h"
#include "almanac/sky.h"
#include "colour/registration.h"
#include "texture/image.h"
#include "uses/picture/moon.h"
#include "uses/picture/view.h"
#include "uses/study/fit_light.h"

namespace coppermoon::uses {

/// The Moon of one moment as a place on Earth sees it, which photographs of it are held against.
struct FitScene {
  algebra::Grid<float> sunlit;      ///< small picture without the shadow; 1: a white ground at 1 au
  algebra::Grid<float> usual;       ///< its luminance under the usual air, to be recognised by
  std::vector<LitPlace> places;     ///< pixels well within the disc; bins: steps of axis distance
  std::vector<std::size_t> pixels;  ///< the pixel of each place: row × columns + column
  std::size_t bins = 0;
  std::optional<FittedLight> light{};  ///< channels X, Y, Z
};

/// The scene that photographs of one moment are held against.
///
/// Given   moon  its light as FittedLight takes it, its map and photometry
///         view  the observer, and the air above; the frame is one of its own
/// Throws  Error as view_of; when no eclipse is under way
FitScene fit_scene(const MoonRequest& moon, const ViewRequest& view, const almanac::SkyState& sky);

/// A photograph's light over a scene's bins.
struct BinnedPhotograph {
  algebra::Grid<double>
      values;  ///< (bin, channel), linear Rec.709: light over sunlit; 0: not known
  algebra::Grid<double> errors;  ///< standard errors of the values, by the scatter of their pixels
  colour::Registration registration{};
};

/// Registers a photograph and sums up its light. Clipped pixels are left out, and a bin with them where
/// they are more than half a hundredth of it. The sky's light, found beside the disc, is taken off.
///
/// Given   photo  linear, 1 saturates
/// Throws  Error  as colour::registered
BinnedPhotograph binned(const FitScene& scene, const texture::Image& photo);

}  // namespace coppermoon::uses
