// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "algebra/grid.h"

namespace coppermoon::colour {

/// The Moon's disc in a picture, in pixels from the upper left corner; y points down.
struct Disc {
  double x_px, y_px, radius_px;
};

/// Finds the Moon's disc in a picture that shows all or part of its limb.
///
/// First, circles are drawn through three random edges at a time, and edges vote for them, under four tone curves.
/// These range from one that shows the dimmest limb to one in which the blocks and ringing of JPEG vanish beside the
/// brightest. Along a limb, light falls outward everywhere, unlike at the edge of the Earth's shadow. The limb is then
/// located along 360 radii from the area under each drop in light, which blur does not change. The circle is fitted to
/// these places by least squares without outliers. The circle along which light drops most is the limb. All this is
/// done in a picture binned to at most 400 pixels, or to fewer if noise hides the limb; around the brightest place if
/// nothing else is found; and once more close up.
///
/// Given     luminance  scene-linear, on any scale; saturated pixels have the largest value
/// Returned  nothing unless a circle is limb along at least a quarter, is round and is surrounded by an even sky. So
///           nothing if there is no Moon, or if it is cut off too far, has a radius below 6 pixels, or is flattened by
///           air by more than 4 %. Anything as round as a Moon passes for one
/// Accuracy  0.25 pixel in place and radius for discs of 40 to 160 pixels blurred by 1 pixel; 0.5 for those blurred by
///           2.5 with noise of 2 % of the brightest, and for those whose dark side is lost in noise. A clipped limb
///           appears further out by one or two blur widths. In JPEGs of quality 50 to 100 that are blurred, noisy, up
///           to 30 times too bright, and in which a person sees a third of the limb, 99 of 100 discs are found if their
///           radius is at least 20 pixels and 2 % of the picture, 97 of 100 from 10 pixels on. Their error is at
///           most the sum of 2 % of the radius, half a pixel, half the blur and the shift of a clipped limb. If less
///           than half of the limb is seen, the error grows by the factor 1 / (1 - cos of half the arc)
/// Throws    Error      when a luminance is not finite, or a side is below 16 or above 65535 pixels
std::optional<Disc> limb_of(const algebra::Grid<float>& luminance);

}  // namespace coppermoon::colour
