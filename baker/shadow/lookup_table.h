// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "algebra/grid.h"
#include "shadow/sectors.h"

namespace coppermoon::shadow {

/// Coordinates of many places in the frame of eclipse::ShadowAxis; the spans have equal lengths.
struct Places {
  std::span<const double> east_m, north_m, depth_m;
};

/// Nodes of axis distance, denser where light varies faster. Cells of equal width are each divided into equal parts.
struct UnevenNodes {
  double first_m = 0, cell_m = 1;  ///< axis distance of the first node; width of a cell
  std::vector<double> first_node;  ///< [cell] index of the cell's first node
  std::vector<double> parts;       ///< [cell] number of parts, 1 or more
  std::vector<double> at_m;        ///< [node] axis distance

  std::size_t count() const { return at_m.size(); }
};

/// Nodes for cells that are divided into the given numbers of parts.
UnevenNodes uneven_nodes(double first_m, double cell_m, std::span<const double> parts);

/// Channel values by plane, sector and node of axis distance.
struct LookupTable {
  std::size_t channels = 0;
  std::vector<double> depths_m;  ///< depths of the planes, increasing
  double middle_depth_m = 0;     ///< depth at which the nodes' axis distances apply; see `sheared`
  std::vector<double> sunlight;  ///< [channel], padded; value in full sunlight
  Sectors sectors{};             ///< sectors that the table holds
  /// number of sectors held; if these are not all, it includes one dark sector that stands for all others
  std::size_t held = 1;
  UnevenNodes nodes;
  double end_m = 0;  ///< beyond this axis distance there is full sunlight
  /// indexed by (row, padded channel), with row = (plane × held + sector − first sector) × nodes + node
  algebra::Grid<float> values;
};

/// Typical impact parameter of rays past the limb [m].
inline constexpr double limb_m = 6.39e6;

/// Axis distance within which light arrives from the limb on both sides of the axis [m].
inline constexpr double one_limb_m = 1.5e6;

/// Follows a straight line from the limb between two planes of the shadow, and returns the axis distance at which it
/// crosses the second plane. Light in the shadow hardly changes along these lines. Near the axis, where lines from the
/// opposite limb cross them, the change in axis distance is scaled down, to 0 on the axis.
///
/// Given  axis_distance_m  axis distance at which the line crosses the first plane
///        deeper           depth of the second plane, divided by that of the first
inline double sheared(double axis_distance_m, double deeper) {
  // FAULT the look-up's planes sheared the wrong way: (deeper - 1); => (1 - deeper);
  const double shift = (axis_distance_m - limb_m) * (deeper - 1);
  return axis_distance_m + shift * std::min(1., axis_distance_m / one_limb_m);
}

/// Rows of the table are padded to a multiple of this number of channels, so that whole vectors can be read.
inline constexpr std::size_t channel_padding = 4;

/// Reads the table by interpolation: linear between planes and nodes, cubic in position angle. The result is at least 0
/// (or the least value in the four sectors, if that is negative). Outside the table, the values at the outermost planes
/// and nodes apply. Beyond `end_m`, and on the Sun's side of the Earth, there is full sunlight.
///
/// Given     table   with two nodes or more; if it has none, there is full sunlight everywhere
/// Returned  values  [place × channels + channel]
void read(const LookupTable& table, const Places& places, std::span<double> values);

}  // namespace coppermoon::shadow
