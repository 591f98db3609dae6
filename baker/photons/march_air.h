// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "atmosphere/atmosphere.h"

namespace coppermoon::photons {

/// Look-up table of a column of air for marching, by the reduced height
///
///     q = (|x|² − R²) / 2R = h + h² / 2R
///
/// which needs no square root. Cells have equal heights. A cell holds a cubic of the density ratio and, for each
/// other profile of the column, a straight line with the right mean. Layers lie between breaks of the air; a cell
/// that contains a break is stored once for either layer, so that breaks stay sharp. In layer i the cell of q is
/// floor(q × cells_per_m) + cells_below_ground + i. The last layer is empty space. The table reaches 2 km below the
/// ground.
///
/// Accuracy  relative, 1e-9 for the density ratio, 1e-7 for its slope; with floats 3e-6 for both
template <class T>
struct MarchAir {
  static constexpr std::size_t density_terms = 4, border_terms = 4;

  /// [cell](c₀, c₁, c₂, c₃ of the density ratio; then value and slope of each other profile); the variable runs
  /// from 0 to 1 in a cell
  std::vector<T> cells;
  /// [layer](density at the layer's upper end; jumps there, upwards, of density, of its slope [m⁻¹], of its
  /// curvature [m⁻²]; then of each other profile)
  std::vector<T> borders;
  std::vector<T> lower_m, upper_m;  ///< q at each layer's ends; rays stay above the first
  std::vector<std::size_t> others;  ///< atmosphere::Absorber of the profiles besides air
  T earth_radius_m, cells_per_m, cells_below_ground, lowest_m, highest_m;  // of q

  T density_at_top() const { return borders[borders.size() - 2 * terms_of_border()]; }
  std::size_t terms() const { return density_terms + 2 * others.size(); }
  std::size_t terms_of_border() const { return border_terms + others.size(); }
};

/// Table of a column.
///
/// Given     earth_radius_m  radius of curvature of the ground along the path
/// Returned  no layers for a column without air
template <class T>
MarchAir<T> march_air(const atmosphere::Column& column, double earth_radius_m);

/// Reduced height q of an altitude, and its inverse.
double reduced_height_m(double altitude_m, double earth_radius_m);
double altitude_of_reduced_m(double reduced_m, double earth_radius_m);

}  // namespace coppermoon::photons
