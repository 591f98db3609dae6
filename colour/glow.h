// SPDX-License-Identifier: MIT
#pragma once

#include "colour/display.h"

namespace coppermoon::colour {

/// Normalised profile of the aureole around a point source, due to scattering in glass, mirrors, dust and thin haze.
///
///     p = (b² − a²) / (π ln(b²/a²) (a² + θ²) (b² + θ²))        a = 20″, b = 6°
///
/// Between a and b, p falls off with the square of the angle.
///
/// Returned  p per steradian; its integral over all directions is 1
/// Omits     differences between telescopes (published aureoles fall off with the 1.6th to 3rd power of the angle);
///           colour; reflections between lenses
/// Source    King (1971), PASP 83, 199; Racine (1996), PASP 108, 699; Sandin (2014), A&A 567, A97
double glow_spread_per_sr(double angle_rad);

/// Share of the aureole's light within an angle of the source: ln((1 + θ²/a²) / (1 + θ²/b²)) / ln(b²/a²).
double glow_within(double angle_rad);

/// Convolves a picture with the aureole: each point keeps 1 − share of its light and spreads the rest.
///
/// Given     share      0 to 0.5
///           pixel_rad  angle across a pixel, 1e-12 to 1
/// Returned  the convolved picture; light is conserved, except for what leaves the frame
/// Accuracy  1e-6 relative to the glow's mean over a pixel
/// Omits     glow from sources beyond the frame
/// Throws    Error      when share or pixel_rad is outside its range
Image with_glow(const Image& picture, double share, double pixel_rad);

}  // namespace coppermoon::colour
