// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "shadow/landed_light.h"

namespace coppermoon::shadow {

/// sums[lane] += Σ factor row[moment][lane] over terms, with what the machine has of SIMD.
///
/// Given  rows   [node − first][moment][lane];  sums: [lane]
void add_weighted_rows(const double* rows, int first, std::span<const NodeTerm> terms,
                       double* sums);

}  // namespace coppermoon::shadow
