// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "algebra/grid.h"
#include "colour/limb.h"
#include "colour/similarity.h"

namespace coppermoon::colour {

/// Position of a rendered Moon in a photograph.
struct Registration {
  Similarity render_to_photo;
  double correlation;  ///< of local contrasts within 0.92 of the disc's radius, −1 to 1
  Disc in_photo{};     ///< fitted to the photograph's limb
};

/// What is known of both pictures before a registration.
struct KnownBefore {
  std::optional<Disc> in_photo = {}, in_render = {};  ///< else by limb_of
  /// of the similarity: the photograph's disc then has the size of the render's times that, about the same centre
  std::optional<double> scale = {};
  bool roughly = false;  ///< to a hundredth of the radius, in a tenth of the time
};

/// Finds a rendered Moon in a photograph of it.
///
/// The limbs give place and size. Both discs are brought to one size, and light is divided by what
/// it is nearby, within the disc, less 1: that is the high-passed logarithm of small contrasts, and
/// at the limb a step from 0 to −1 however bright the limb is, which blur does not move. What
/// correlates best around the discs, mirrored or not, at any angle, says how they are turned; then
/// angle, size and place are changed together until maria and limb correlate best.
///
/// Given     photo, render  luminance, scene-linear, each of its own scale; what saturated the
///                          camera has the photograph's largest value, and as much of the
///                          render's disc, its brightest, counts as equally bright
/// Accuracy  0.2° of rotation and 0.3 % of scale, or 0.2 pixel at the limb where that is more; 0.25
///           pixel at the disc's centre. In the photograph: radii of 25 to 150 pixels, blur by 2,
///           noise of 2 % of the brightest, a clipped disc, the Earth's shadow. Where all but the
///           umbra is clipped, 33 times too bright: 0.6 pixel and 1 %. One in thirty small discs (25
///           pixels, blur by 2) was turned by 0.5°. Of maps of the same Moon by two hands: 0.3°
/// Throws    Error  as limb_of; when it finds no disc in either, or the correlation is below 0.4:
///                  nothing is seen on the Moon, or it is another (up to 0.29 by chance); when that of
///                  what varies around the disc is below 0.3: both are alike in how light goes from
///                  the middle to the limb alone, as a Sun may be. A render of another hour may come
///                  above both, by its shadow, and lie anyhow
Registration registered(const algebra::Grid<float>& photo, const algebra::Grid<float>& render,
                        const KnownBefore& known = {});

}  // namespace coppermoon::colour
