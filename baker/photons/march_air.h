// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "atmosphere/atmosphere.h"

namespace coppermoon::photons {

/// A column of air as a march through it looks it up: by the reduced height
///
///     q = (|x|² − R²) / 2R = h + h² / 2R
///
/// which takes no square root, in cells of equal height. A cell holds a cubic of the density ratio,
/// and a straight line with the right mean for each other profile the column has. Between two breaks
/// of the air lies a layer; a cell with a break in it stands there once for either layer, so that
/// nothing is smoothed over. In layer i the cell of q is floor(q × cells_per_m) + cells_below_ground
/// + i. The last layer is empty space. Below the ground the air goes on for 2 km.
///
/// Accuracy  of the density ratio 1e-9, of its slope 1e-7 relative; as a float 3e-6 of both
template <class T>
struct MarchAir {
  static constexpr std::size_t density_terms = 4, border_terms = 4;

  /// [cell](c₀, c₁, c₂, c₃ of the density ratio; then value and slope of each other profile), along
  /// a cell from 0 to 1
  std::vector<T> cells;
  /// [layer](density; jumps, upwards, of it, its slope [m⁻¹], its curvature [m⁻²]; then the jump of
  /// each other profile), at the layer's upper end
  std::vector<T> borders;
  std::vector<T> lower_m, upper_m;  ///< q at each layer's ends; no ray gets below the first
  std::vector<std::size_t> others;  ///< the profiles besides air, as atmosphere::Absorber
  T earth_radius_m, cells_per_m, cells_below_ground, lowest_m, highest_m;  // of q

  T density_at_top() const { return borders[borders.size() - 2 * terms_of_border()]; }
  std::size_t terms() const { return density_terms + 2 * others.size(); }
  std::size_t terms_of_border() const { return border_terms + others.size(); }
};

/// Given     earth_radius_m  of the ground's curvature along the path
/// Returned  no layers for a column without air
template <class T>
MarchAir<T> march_air(const atmosphere::Column& column, double earth_radius_m);

/// q of an altitude, and the altitude of q.
double reduced_height_m(double altitude_m, double earth_radius_m);
double altitude_of_reduced_m(double reduced_m, double earth_radius_m);

}  // namespace coppermoon::photons
