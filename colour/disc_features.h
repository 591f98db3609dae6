// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/grid.h"
#include "colour/moon_limb.h"
#include "colour/similarity.h"

namespace coppermoon::colour {

/// Local contrast on a disc: the ratio of light to its local mean, minus 1.
struct DiscFeatures {
  algebra::Grid<float> contrast;  ///< −1 beyond the limb
  algebra::Grid<float> weight;    ///< 0 to 1; 0 where the picture carries no information
  Similarity from_picture;        ///< to these grids, both centred on the disc
  double floor;                   ///< noise floor, relative to the disc's 99th percentile
};

/// Range of light that a picture resolves.
struct TonalRange {
  double clipped = 0;   ///< saturated share of the disc
  double floor = 0;     ///< as in DiscFeatures
  bool deeply = false;  ///< whether the saturated share ends at the edge of a shadow: is_deep
};

/// Saturated share of a disc: the share of its pixels within a hundredth of the picture's largest value.
double clipped_share(const algebra::Grid<float>& picture, const Disc& disc);

/// Whether the brightest part of a picture is at least four times as bright as the saturation level. If so, the edge of
/// the clipped area is due to exposure and air, not to markings on the Moon.
///
/// Given  picture  not clipped
///        clipped  saturated share of the disc
bool is_deep(const algebra::Grid<float>& picture, const Disc& disc, double clipped);

/// Features of a disc, scaled to a given radius.
///
/// Given  radius_px  at most the disc's own
///        range      no wider than the picture's own
DiscFeatures features_of(const algebra::Grid<float>& picture, const Disc& disc, double radius_px,
                         const TonalRange& range);

}  // namespace coppermoon::colour
