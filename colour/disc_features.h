// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/grid.h"
#include "colour/limb.h"
#include "colour/similarity.h"

namespace coppermoon::colour {

/// Local contrast on a disc: light over its local mean, less 1.
struct DiscFeatures {
  algebra::Grid<float> contrast;  ///< −1 beyond the limb
  algebra::Grid<float> weight;    ///< 0 to 1; 0 where the picture carries no information
  Similarity from_picture;        ///< to these grids; the disc's centre is the middle of both
  double floor;                   ///< noise floor, over the 99th percentile of the disc's light
};

/// Range of light that a picture resolves.
struct TonalRange {
  double clipped = 0;   ///< saturated share of the disc
  double floor = 0;     ///< as DiscFeatures has it
  bool deeply = false;  ///< whether the saturated share ends at the edge of a shadow: is_deep
};

/// Saturated share of a disc: pixels within a hundredth of the picture's largest value.
double clipped_share(const algebra::Grid<float>& picture, const Disc& disc);

/// Whether the brightest of a picture is four times as bright as what saturates or more: then exposure and air make the
/// edge of what is clipped, not markings.
///
/// Given  picture  not clipped
///        clipped  saturated share of the disc
bool is_deep(const algebra::Grid<float>& picture, const Disc& disc, double clipped);

/// Features of a disc scaled to a radius.
///
/// Given  radius_px  not above the disc's own
///        range      no wider than the picture's own
DiscFeatures features_of(const algebra::Grid<float>& picture, const Disc& disc, double radius_px,
                         const TonalRange& range);

}  // namespace coppermoon::colour
