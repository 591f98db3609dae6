// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "algebra/grid.h"
#include "shadow/landed_light.h"

namespace coppermoon::shadow {

/// sums[lane] += Σ factors[node][moment] rows[node][moment][lane], with what the machine has of SIMD.
///
/// Given  factors  of the first node; those of the next are `stride` behind
///        sums     [lane]
void add_weighted_rows(const double* rows, std::size_t nodes, const double* factors,
                       std::size_t stride, double* sums);

/// sums[i][moment][lane] += factor row[nodes[i]][moment][lane], likewise.
///
/// Given  rows  [node − first][moment][lane]; nodes before the first and after the last count as these
void add_rows_at(const double* rows, int first, int last, std::span<const int> nodes, double factor,
                 double* sums);

/// Position angles that stand side by side.
inline constexpr std::size_t angles_together = 8;

/// turned[i][column][angle] = Σ factors(harmonic, column) turns[i][harmonic][angle], likewise.
void turn_factors(const algebra::Grid<double>& factors,
                  const std::vector<std::vector<double>>& turns, std::vector<double>& turned);

/// sums[term][angle][lane] += Σ factors[i][term][moment][angle] row[nodes[i]][moment][lane], likewise.
///
/// Given  rows  as add_rows_at has them
void add_turned_rows(const double* rows, int first, int last, std::span<const int> nodes,
                     const double* factors, std::size_t terms, double* sums);

/// Nodes come in groups of this many: what is left over has no weight.
inline constexpr std::size_t nodes_together = 4;

/// harmonics(k, m) += Σ weights(k, j) cos mψ_j over nodes j, by recurrence, likewise.
///
/// Given  cosines  cos ψ_j, a multiple of nodes_together
void add_harmonics(std::span<const double> cosines, const algebra::Grid<double>& weights,
                   algebra::Grid<double>& harmonics);

}  // namespace coppermoon::shadow
