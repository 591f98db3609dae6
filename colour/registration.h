// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "algebra/grid.h"
#include "colour/moon_limb.h"
#include "colour/similarity.h"

namespace coppermoon::colour {

/// Position of a rendered Moon in a photograph.
struct Registration {
  Similarity render_to_photo;
  double correlation;  ///< correlation of local contrast within 0.92 of the disc's radius, −1 to 1
  Disc in_photo{};     ///< circle fitted to the photograph's limb
};

/// What is known about both pictures before registration.
struct KnownBefore {
  std::optional<Disc> in_photo = {}, in_render = {};  ///< if absent, found with limb_of
  /// Scale of the similarity. If it is given, the photograph's disc keeps its centre, and its radius is the render's
  /// radius times this scale.
  std::optional<double> scale = {};
  bool roughly = false;  ///< accurate to only a hundredth of the radius, but ten times as fast
};

/// Finds a rendered Moon in a photograph of it.
///
/// The limbs give position and size. Both discs are scaled to the same size, and their local contrast is computed: the
/// ratio of light to its local mean within the disc, minus 1. For small contrasts this is the high-passed logarithm of
/// light. At the limb it drops from 0 to −1 however bright the limb is, and blur does not move that drop. The rotation
/// is the one at which the discs correlate best, mirrored or not. Then rotation, size and position are refined together
/// until maria and limb correlate best.
///
/// Given     photo, render  scene-linear luminance, each on its own scale. Saturated pixels have the photograph's
///                          largest value; the same share of the render's disc, its brightest part, is treated as
///                          saturated
/// Accuracy  0.2° in rotation and 0.3 % in scale, or 0.2 pixel at the limb if that is more; 0.25 pixel at the disc's
///           centre. These hold for radii of 25 to 150 pixels, a blur of 2 pixels, noise of 2 % of the brightest pixel,
///           clipped discs and the Earth's shadow. If the photograph is 33 times too bright, so that all but the umbra
///           is clipped: 0.6 pixel and 1 %. One in thirty small discs (25 pixels, blur of 2) had its rotation off by
///           0.5°. Between maps of the Moon from two sources, rotations differ by 0.3°
/// Throws    Error  as for limb_of; when no disc is found in one of the pictures. When the correlation is below 0.4 (up
///                  to 0.29 occurs by chance): nothing is visible on the Moon, or it is not the Moon. When the
///                  correlation of markings is below 0.3: the pictures are alike only in how light falls off towards
///                  the limb, as it does on the Sun. A render for another hour may pass both tests because of its
///                  shadow, yet be placed wrongly
Registration registered(const algebra::Grid<float>& photo, const algebra::Grid<float>& render,
                        const KnownBefore& known = {});

}  // namespace coppermoon::colour
