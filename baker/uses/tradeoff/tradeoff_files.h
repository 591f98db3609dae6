// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "uses/plot/plot.h"
#include "uses/tradeoff/runs.h"

namespace coppermoon::uses {

/// Trials as a table in Markdown, the settings in one cell.
std::string as_markdown(std::span<const Measured> all);

/// Plot of the umbra's error by seconds, a line for each sweep, a colour for each solver. Open symbols are
/// extrapolated, a star is the setting of Yapo and Cutler (2009).
Plot as_plot(std::span<const Measured> all);

}  // namespace coppermoon::uses
