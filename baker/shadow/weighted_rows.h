// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "algebra/grid.h"
#include "shadow/landed_light.h"

namespace coppermoon::shadow {

/// sums[lane] += Σ factor row[moment][lane] over terms, with what the machine has of SIMD.
///
/// Given  rows  [node][moment][lane]
///        sums  [lane]
void add_weighted_rows(const double* rows, std::span<const NodeTerm> terms, double* sums);

/// sums[i][moment][lane] += factor row[nodes[i]][moment][lane], likewise.
///
/// Given  rows  [node − first][moment][lane]; nodes before the first and after the last count as these
void add_rows_at(const double* rows, int first, int last, std::span<const int> nodes, double factor,
                 double* sums);

/// Nodes come in groups of this many: what is left over has no weight.
inline constexpr std::size_t nodes_together = 4;

/// harmonics(k, m) += Σ weights(k, j) cos mψ_j over nodes j, by recurrence, likewise.
///
/// Given  cosines  cos ψ_j, a multiple of nodes_together
void add_harmonics(std::span<const double> cosines, const algebra::Grid<double>& weights,
                   algebra::Grid<double>& harmonics);

}  // namespace coppermoon::shadow
