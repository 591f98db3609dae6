// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/grid.h"
#include "colour/moon_limb.h"
#include "colour/similarity.h"

namespace coppermoon::colour {

/// Local contrast on a disc: the ratio of light to its local mean, minus 1.
struct DiscFeatures {
  algebra::Grid<float> contrast;  ///< −1 beyond the limb
  algebra::Grid<float> weight;    ///< 0 to 1; 0 at pixels that carry no information
  Similarity from_picture;        ///< maps the picture to these grids, which have the disc centred
  double floor;                   ///< noise floor / 99th percentile of the disc's light
};

/// Range of light that a picture resolves.
struct TonalRange {
  double clipped = 0;   ///< share of the disc that is saturated
  double floor = 0;     ///< relative noise floor, as in DiscFeatures
  bool deeply = false;  ///< whether the saturated area ends at a shadow's edge (see is_deep)
};

/// Saturated share of a disc: the share of its pixels that are within 1 % of the picture's largest value.
double clipped_share(const algebra::Grid<float>& picture, const Disc& disc);

/// Whether the 99th percentile of the disc's light is more than four times the clipping level, which is the quantile
/// 1 - `clipped`. If so, the edge of the clipped area depends on exposure and air, not on the Moon's markings.
///
/// Given  picture  picture that is not clipped itself
///        clipped  share of the disc's pixels that are saturated in another picture of it
bool is_deep(const algebra::Grid<float>& picture, const Disc& disc, double clipped);

/// Local contrast of a disc, scaled to a given radius.
///
/// Given  radius_px  radius of the disc in the result, at most the disc's own radius
///        range      tonal range of the result, no wider than the range that the picture resolves
DiscFeatures features_of(const algebra::Grid<float>& picture, const Disc& disc, double radius_px,
                         const TonalRange& range);

}  // namespace coppermoon::colour
