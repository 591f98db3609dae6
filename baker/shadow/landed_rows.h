// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "algebra/grid.h"
#include "shadow/landed_light.h"

namespace coppermoon::shadow {

/// One harmonic of the position angle, to which rows of landed light are added.
struct HarmonicRows {
  const double* weights;  ///< [part]
  const double* factors;  ///< [node][term][moment]
  double* sums;           ///< [term][lane], increased by the light
};

/// Adds, for each harmonic, sums[term][lane] += Σ factors[i][term][moment] Σ weights[part] row of
/// part[nodes[i]][moment][lane], with the machine's widest vectors. A node before a part's first counts as the first,
/// and one after its last as the last.
///
/// Given  parts  light from each part of the limb
void add_landed_rows(std::span<const LandedLight> parts, std::span<const int> nodes,
                     std::size_t terms, std::span<const HarmonicRows> harmonics);

/// Number of position angles that are stored side by side.
inline constexpr std::size_t angles_together = 8;

/// Writes turned[i][column][angle] = Σ factors(harmonic, column) turns[i][harmonic][angle], vectorised.
void turn_factors(const algebra::Grid<double>& factors,
                  const std::vector<std::vector<double>>& turns, std::vector<double>& turned);

/// Adds sums[term][angle][lane] += Σ factors[i][term][moment][angle] row[nodes[i]][moment][lane], vectorised.
void add_turned_rows(const LandedLight& part, std::span<const int> nodes, const double* factors,
                     std::size_t terms, double* sums);

/// Number of nodes in a group; the last group is padded with nodes of weight 0.
inline constexpr std::size_t nodes_together = 4;

/// Replaces angles [rad] by their cosines, vectorised. The number of angles is a multiple of nodes_together.
void turn_into_cosines(std::span<double> angles);

/// Adds harmonics(k, m) += Σ weights(k, j) cos mψ_j over nodes j, by recurrence, vectorised.
///
/// Given  cosines  cos ψ_j; their number is a multiple of nodes_together
void add_harmonics(std::span<const double> cosines, const algebra::Grid<double>& weights,
                   algebra::Grid<double>& harmonics);

}  // namespace coppermoon::shadow
