// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "uses/fit/fit_results.h"

namespace coppermoon::verbs {

/// Prints the results of a fit: photographs, air, cameras, and the flags that give this air to other commands.
void print_fit(const uses::FitReport& found);

/// Prints how the light of each photograph and channel differs from the fitted air. Prints nothing without photographs.
void print_misfits(const uses::FitReport& found);

/// One-line message for a fit whose best model of the air does not explain the data. It states χ², the photograph and
/// channel with the largest misfit, and what to try.
std::string misfit_in_words(const uses::FitReport& found);

}  // namespace coppermoon::verbs
