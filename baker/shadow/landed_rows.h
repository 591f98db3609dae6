// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "algebra/grid.h"
#include "shadow/landed_light.h"

namespace coppermoon::shadow {

/// Inputs for one harmonic of the position angle, and its sums, to which add_landed_rows adds.
struct HarmonicRows {
  const double* weights;  ///< weight of each part of the limb
  const double* factors;  ///< [node][term][moment]
  double* sums;           ///< [term][lane], to which light is added
};

/// For each harmonic, adds Σ factors[i][term][moment] Σ weights[part] row[part][nodes[i]][moment][lane] to
/// sums[term][lane], with the machine's widest vectors. The sums run over nodes i, moments and parts. If a node is
/// outside a part's range, the nearest node in the range is used.
///
/// Given  parts  light from each part of the limb
void add_landed_rows(std::span<const LandedLight> parts, std::span<const int> nodes,
                     std::size_t terms, std::span<const HarmonicRows> harmonics);

/// Number of position angles that are stored side by side, to be processed by vector instructions.
inline constexpr std::size_t angles_together = 8;

/// Converts factors for harmonics to factors for position angles. `turns[i]` holds the value of each harmonic in the
/// series of part i's share: turned[i][column][angle] = Σ_harmonic factors(harmonic, column) turns[i][harmonic][angle].
void turn_factors(const algebra::Grid<double>& factors,
                  const std::vector<std::vector<double>>& turns, std::vector<double>& turned);

/// Adds Σ factors[i][term][moment][angle] row[nodes[i]][moment][lane], over i and moments, to sums[term][angle][lane].
void add_turned_rows(const LandedLight& part, std::span<const int> nodes, const double* factors,
                     std::size_t terms, double* sums);

/// Number of quadrature nodes that are processed together. The last group is padded with nodes of weight 0.
inline constexpr std::size_t nodes_together = 4;

/// Replaces angles [rad] by their cosines, with vector instructions. `angles.size()` is a multiple of nodes_together.
void turn_into_cosines(std::span<double> angles);

/// Adds Σ weights(k, j) cos mψ_j over nodes j to harmonics(k, m), by recurrence and with vector instructions.
///
/// Given  cosines  cos ψ_j; their number must be a multiple of nodes_together
void add_harmonics(std::span<const double> cosines, const algebra::Grid<double>& weights,
                   algebra::Grid<double>& harmonics);

}  // namespace coppermoon::shadow
