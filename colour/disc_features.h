// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/grid.h"
#include "colour/limb.h"
#include "colour/similarity.h"

namespace coppermoon::colour {

/// Markings of a disc: light over its mean nearby, less 1.
struct DiscFeatures {
  algebra::Grid<float> contrast;  ///< −1 beyond the limb
  algebra::Grid<float> weight;    ///< 0 to 1; 0 where a picture has nothing to say
  Similarity from_picture;        ///< to these grids; the disc's centre is the middle of both
  double floor;  ///< light that noise hides, over that which a hundredth of the disc exceeds
};

/// The range within which a camera told light apart.
struct TonalRange {
  double clipped = 0;  ///< share of the disc, its brightest part, that looks the same
  double floor = 0;    ///< as DiscFeatures has it
};

/// The share of a disc's pixels that have the picture's largest value, within a hundredth.
double clipped_share(const algebra::Grid<float>& picture, const Disc& disc);

/// The features of a disc brought to a radius.
///
/// Given  radius_px  not above the disc's own
///        range      at most what the picture itself tells apart
DiscFeatures features_of(const algebra::Grid<float>& picture, const Disc& disc, double radius_px,
                         const TonalRange& range);

}  // namespace coppermoon::colour
