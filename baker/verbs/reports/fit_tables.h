// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "uses/fit/fit_results.h"

namespace coppermoon::verbs {

/// Prints what a fit found: photographs, unknowns, cameras, and the flags that bake it.
void print_fit(const uses::FitReport& found);

/// Prints how photographs and channels differ from the air found; nothing without photographs.
void print_misfits(const uses::FitReport& found);

/// Message, in one line, for air that explains nothing: χ², the photograph and channel that misfit most, what to try.
std::string misfit_in_words(const uses::FitReport& found);

}  // namespace coppermoon::verbs
