// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "algebra/grid.h"
#include "shadow/landed_light.h"

namespace coppermoon::shadow {

/// Rows of one part of the limb: [node − first][moment][lane]; nodes before the first and after the last
/// count as these.
struct PartRows {
  const double* rows;
  int first, last;
};

/// One harmonic of the position angle.
struct HarmonicRows {
  const double* weights;  ///< [part]
  const double* factors;  ///< [node][term][moment]
  double* sums;           ///< [term][lane], that are added to
};

/// sums[term][lane] += Σ factors[i][term][moment] Σ weights[part] row of part[nodes[i]][moment][lane] of
/// each harmonic, with what the machine has of SIMD.
void add_weighted_rows(std::span<const PartRows> parts, std::span<const int> nodes,
                       std::size_t terms, std::span<const HarmonicRows> harmonics);

/// Position angles that stand side by side.
inline constexpr std::size_t angles_together = 8;

/// turned[i][column][angle] = Σ factors(harmonic, column) turns[i][harmonic][angle], likewise.
void turn_factors(const algebra::Grid<double>& factors,
                  const std::vector<std::vector<double>>& turns, std::vector<double>& turned);

/// sums[term][angle][lane] += Σ factors[i][term][moment][angle] row[nodes[i]][moment][lane], likewise.
///
void add_turned_rows(const PartRows& part, std::span<const int> nodes, const double* factors,
                     std::size_t terms, double* sums);

/// Nodes come in groups of this many: what is left over has no weight.
inline constexpr std::size_t nodes_together = 4;

/// harmonics(k, m) += Σ weights(k, j) cos mψ_j over nodes j, by recurrence, likewise.
///
/// Given  cosines  cos ψ_j, a multiple of nodes_together
void add_harmonics(std::span<const double> cosines, const algebra::Grid<double>& weights,
                   algebra::Grid<double>& harmonics);

}  // namespace coppermoon::shadow
