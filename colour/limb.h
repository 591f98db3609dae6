// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "algebra/grid.h"

namespace coppermoon::colour {

/// The Moon's disc in a picture, in pixels from the upper left corner; y down.
struct Disc {
  double x_px, y_px, radius_px;
};

/// The disc of a Moon whose limb is in a picture, all or some of it.
///
/// Edges of a tone curve that shows dim limbs beside bright ones vote for circles, three random
/// edges at a time; light falls outward across all of a limb, as it does not across the edge of the
/// Earth's shadow. Then the limb is measured along 360 radii, by the area under each step of light,
/// which no blur moves, and the circle is fitted to those places by least squares without outliers.
///
/// Given     luminance  scene-linear, of any scale; what saturated the camera has the largest value
/// Returned  nothing when no circle has a limb along a quarter of it in the picture: no Moon, one
///           cut off, one whose radius is below 6 pixels, or one that air flattens by more than 4 %
/// Accuracy  0.25 pixel in place and radius for discs of 40 to 160 pixels blurred by 1 pixel, 0.5
///           for those blurred by 2.5 with noise of 2 % of the brightest, and for those whose dark
///           side is lost in noise. A limb that is clipped seems further out by a blur or two
/// Throws    Error      when a luminance is not finite, or a side is below 16 or above 65535 pixels
std::optional<Disc> limb_of(const algebra::Grid<float>& luminance);

}  // namespace coppermoon::colour
