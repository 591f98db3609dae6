// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "algebra/grid.h"
#include "shadow/sectors.h"

namespace coppermoon::shadow {

/// Places in the shadow, many at once: coordinates in the frame of eclipse::ShadowAxis, as many of
/// each.
struct Places {
  std::span<const double> east_m, north_m, depth_m;
};

/// Axis distances, closer where more happens: even cells, each cut into so many equal parts.
struct UnevenNodes {
  double first_m = 0, cell_m = 1;  ///< of the first node, and of each cell the width
  std::vector<double> first_node;  ///< [cell] a whole number
  std::vector<double> parts;       ///< [cell] likewise, 1 or more
  std::vector<double> at_m;        ///< [node]

  std::size_t count() const { return at_m.size(); }
};

/// Cells that are cut into so many parts each.
UnevenNodes uneven_nodes(double first_m, double cell_m, std::span<const double> parts);

/// Channel values over place in the shadow, at nodes of axis distance, on planes and in sectors.
struct LookupTable {
  std::size_t channels = 0;
  std::vector<double> depths_m;  ///< of the planes, increasing
  double middle_depth_m = 0;     ///< where nodes are at their axis distances; see `sheared`
  std::vector<double> sunlight;  ///< [channel], padded
  Sectors sectors{};             ///< that are held
  std::size_t held = 1;  ///< their number; with one more, all others, dark, where they are not all
  UnevenNodes nodes;
  double end_m = 0;  ///< beyond this axis distance all is sunlight
  /// ((plane × held + sector, counted from the first held) × nodes + node, padded channel)
  algebra::Grid<float> values;
};

/// Distance from the Earth's centre at which a ray passes the limb [m].
inline constexpr double limb_m = 6.39e6;

/// Axis distance within which light of both limbs counts [m].
inline constexpr double one_limb_m = 1.5e6;

/// Where a straight line from the limb that crosses a plane at one axis distance crosses another
/// plane. Light in the shadow hardly changes along these lines. Near the axis, where the opposite
/// limb's lines cross them, the distance shifts less, on the axis not at all.
///
/// Given  deeper  depth of the other plane over that of the one
inline double sheared(double axis_distance_m, double deeper) {
  // FAULT the look-up's planes sheared the wrong way: (deeper - 1); => (1 - deeper);
  const double shift = (axis_distance_m - limb_m) * (deeper - 1);
  return axis_distance_m + shift * std::min(1., axis_distance_m / one_limb_m);
}

/// Rows of the table are padded to a multiple of this many channels, so that whole vectors can be
/// read.
inline constexpr std::size_t channel_padding = 4;

/// Reads the table: straight lines between planes and between nodes, cubics around the axis that do not
/// fall below 0 between sectors above it. The outermost planes and nodes hold outside, but sunlight
/// begins at `end_m` and on the Sun's side of Earth.
///
/// Given     table   with two nodes or more, or none: sunlight everywhere
/// Returned  values  [place × channels + channel]
void read(const LookupTable& table, const Places& places, std::span<double> values);

}  // namespace coppermoon::shadow
