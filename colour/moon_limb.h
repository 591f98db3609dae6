// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "algebra/grid.h"

namespace coppermoon::colour {

/// The Moon's disc in a picture, in pixels from the upper left corner; y down.
struct Disc {
  double x_px, y_px, radius_px;
};

/// Finds the Moon's disc in a picture that shows all or part of its limb.
///
/// Edges vote for circles, three random ones at a time, under four tone curves. These range from one that shows
/// the dimmest limb to one in which JPEG's blocks and ringing vanish beside the brightest. Light falls
/// outward everywhere along a limb, unlike at the edge of the Earth's shadow. Then the limb is measured
/// along 360 radii by the area under each step of light, which blur does not change, and the circle is
/// fitted to those places by least squares without outliers. The circle on which most light ends is
/// the limb. This is done in a picture of at most 400 pixels, in smaller ones if noise hides the limb,
/// around the brightest place if nothing else is found, and once more close up.
///
/// Given     luminance  scene-linear, of any scale; saturated pixels have the largest value
/// Returned  nothing unless some circle is limb along at least a quarter, is round and stands before an
///           even sky. So nothing for no Moon, one cut off, one whose radius is below 6 pixels, or one
///           that air flattens by more than 4 %. Anything as round as a Moon passes for one
/// Accuracy  0.25 pixel in place and radius for discs of 40 to 160 pixels blurred by 1 pixel; 0.5
///           for those blurred by 2.5 with noise of 2 % of the brightest, and for those whose dark
///           side is lost in noise. A clipped limb appears further out by one or two blur widths. In
///           JPEGs of quality 50 to 100, blurred, noisy, up to 30 times too bright, in which a person sees
///           a third of the limb, 99 of 100 discs are found if their radius is at least 20 pixels and 2 %
///           of the picture, 97 of 100 from 10 pixels on. The error is within the sum of 2 % of the
///           radius, half a pixel, half the blur and that shift of a clipped limb. If less than half
///           of the limb is seen, it grows by 1 / (1 - cos of half the arc)
/// Throws    Error      when a luminance is not finite, or a side is below 16 or above 65535 pixels
std::optional<Disc> limb_of(const algebra::Grid<float>& luminance);

}  // namespace coppermoon::colour
