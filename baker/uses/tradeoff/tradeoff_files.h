// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "uses/plot/plot.h"
#include "uses/tradeoff/runs.h"

namespace coppermoon::uses {

/// A Markdown table with one row for each trial. One column lists the trial's settings.
std::string as_markdown(std::span<const Measured> all);

/// Plot of the error in the umbra against time, with a line for each sweep and a colour for each solver. Open symbols
/// mark extrapolated trials, and a star marks the settings of Yapo and Cutler (2009).
Plot as_plot(std::span<const Measured> all);

}  // namespace coppermoon::uses
