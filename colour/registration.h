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
  double correlation;  ///< of local contrast within 0.92 of the disc's radius, −1 to 1
  Disc in_photo{};     ///< fitted to the photograph's limb
};

/// What is known about both pictures before registration.
struct KnownBefore {
  std::optional<Disc> in_photo = {}, in_render = {};  ///< if absent, found by limb_of
  /// Scale of the similarity. If given, the photograph's disc keeps its centre and has the render's radius times that.
  std::optional<double> scale = {};
  bool roughly = false;  ///< accurate to only a hundredth of the radius, in a tenth of the time
};

/// Finds a rendered Moon in a photograph of it.
///
/// The limbs give place and size. Both discs are scaled to one size, and light is divided by its
/// local mean within the disc, minus 1. For small contrasts that is the high-passed logarithm; at the
/// limb it is a step from 0 to −1 however bright the limb is, and blur does not move it. The best
/// correlation around the discs, at any angle, mirrored or not, gives the rotation. Then
/// angle, size and place are refined together until maria and limb correlate best.
///
/// Given     photo, render  luminance, scene-linear, each of its own scale. Saturated pixels have the
///                          photograph's largest value; the same share of the render's disc, its
///                          brightest part, counts as equally bright
/// Accuracy  0.2° in rotation and 0.3 % in scale, or 0.2 pixel at the limb if that is more; 0.25
///           pixel at the disc's centre. This holds for photographs with radii of 25 to 150 pixels, blur of 2,
///           noise of 2 % of the brightest, a clipped disc, the Earth's shadow. If all but the
///           umbra is clipped, 33 times too bright: 0.6 pixel and 1 %. One in thirty small discs (25
///           pixels, blur of 2) was rotated by 0.5°. Between maps of the Moon from two sources: 0.3°
/// Throws    Error  as limb_of; when no disc is found in either picture. When the correlation is below 0.4:
///                  nothing is visible on the Moon, or it is not the Moon (up to 0.29 by chance). When
///                  the correlation of markings around the disc is below 0.3: the pictures are alike only
///                  in how light falls from the middle to the limb, as a picture of the Sun may be. A render
///                  for another hour may pass both tests because of its shadow, yet be placed wrongly
Registration registered(const algebra::Grid<float>& photo, const algebra::Grid<float>& render,
                        const KnownBefore& known = {});

}  // namespace coppermoon::colour
