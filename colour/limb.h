// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "algebra/grid.h"

namespace coppermoon::colour {

/// Disc of the Moon in a picture, in pixels from the upper left corner; y down.
struct Disc {
  double x_px, y_px, radius_px;
};

/// Disc of a Moon whose limb is wholly or partly in a picture.
///
/// Edges vote for circles, three random ones at a time, under four tone curves from one that shows
/// the dimmest limb to one in which JPEG's blocks and ringing are nothing beside the brightest; light
/// falls outward across all of a limb, as it does not across the edge of the Earth's shadow. Then the
/// limb is measured along 360 radii, by the area under each step of light, which no blur moves, and the
/// circle is fitted to those places by least squares without outliers. The circle on which most
/// light ends is the limb. This is done in a picture of 400 pixels at most, in smaller ones where
/// noise hides the limb, about the brightest place where nothing else is found, and once more close up.
///
/// Given     luminance  scene-linear, of any scale; what saturated the camera has the largest value
/// Returned  nothing when no circle has a limb along a quarter of it in the picture, is round and
///           stands before an even sky: no Moon, one cut off, one whose radius is below 6 pixels, or
///           one that air flattens by more than 4 %. What is as round as a Moon passes for one
/// Accuracy  0.25 pixel in place and radius for discs of 40 to 160 pixels blurred by 1 pixel, 0.5
///           for those blurred by 2.5 with noise of 2 % of the brightest, and for those whose dark
///           side is lost in noise. A limb that is clipped seems further out by a blur or two. In
///           JPEG of quality 50 to 100, blurred, noisy, up to 30 times too bright, where a person sees
///           a third of the limb, 99 of 100 are found if their radius is 20 pixels and 2 % of the
///           picture or more, 97 of 100 from 10 pixels on: to 2 % of the radius, half a pixel, half
///           the blur and that bloom together; where less than half of the limb is seen, to as much
///           more as a short arc tells less, 1 / (1 - cos of half of it)
/// Throws    Error      when a luminance is not finite, or a side is below 16 or above 65535 pixels
std::optional<Disc> limb_of(const algebra::Grid<float>& luminance);

}  // namespace coppermoon::colour
