// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "uses/fit/fit_results.h"

namespace coppermoon::verbs {

/// Prints what a fit found: photographs, unknowns, cameras, and the flags with which to bake it.
void print_fit(const uses::FitReport& found);

/// Prints how photographs and channels differ from what the fitted air predicts; nothing without photographs.
void print_misfits(const uses::FitReport& found);

/// One-line message for a fit whose air explains nothing: χ², the photograph and channel with the largest misfit, and
/// what to try.
std::string misfit_in_words(const uses::FitReport& found);

}  // namespace coppermoon::verbs
