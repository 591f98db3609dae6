// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "algebra/grid.h"

namespace coppermoon::colour {

/// The Moon's disc in a picture, in pixels from the upper left corner; y points down.
struct Disc {
  double x_px, y_px, radius_px;
};

/// Shortest and longest side of a picture in which limb_of looks for a disc [pixels].
inline constexpr double least_side_px = 16, most_side_px = 65535;

/// Finds the Moon's disc in a picture that shows all or part of its limb.
///
/// First, circles are drawn through three random edges at a time, and the edges that lie on a circle vote for it. This
/// is done with four tone curves, from one that shows the dimmest limb to one that shows only bright light, not JPEG's
/// blocks and ringing. Light must fall outward all along a limb, which is not the case at the edge of the Earth's
/// shadow. The limb is then located on 360 radii from the area under each drop in light, which blur does not change,
/// and a circle is fitted to these points by robust least squares. Of all circles, the one along which light drops most
/// is the limb. The picture is binned to 400 pixels a side, or fewer if noise hides the limb. If nothing is found, the
/// search is repeated around the brightest place. A disc that is found is measured again close up.
///
/// Given     luminance  scene-linear, on any scale; saturated pixels have the largest value
/// Returned  nothing unless limb is found along at least a quarter of a disc, the disc is round, and the sky around it
///           is even. So nothing if there is no Moon, or if the Moon is cut off too far, has a radius below 6 pixels,
///           or is flattened by refraction by more than 4 %. Anything as round as a Moon is taken for one
/// Accuracy  0.25 pixel in position and radius for discs of 40 to 160 pixels that are blurred by 1 pixel; 0.5 pixel for
///           a blur of 2.5 pixels with noise of 2 % of the brightest pixel, and for discs whose dark side is lost in
///           noise. A clipped limb appears further out by one or two blur widths. Tests used blurred, noisy JPEGs of
///           quality 50 to 100, up to 30 times too bright, in which a person sees a third of the limb. Of discs with a
///           radius of at least 2 % of the picture's width, 99 % are found if it is at least 20 pixels, and 97 % if at
///           least 10. Errors are at most 2 % of the radius plus half a pixel, half the blur and the shift of a clipped
///           limb. If less than half the limb is seen, errors grow by the factor 1 / (1 - cos(arc / 2))
/// Throws    Error      when a luminance is not finite, or a side is below least_side_px or above most_side_px
std::optional<Disc> limb_of(const algebra::Grid<float>& luminance);

}  // namespace coppermoon::colour
