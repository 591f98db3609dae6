// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "uses/plot/plot.h"
#include "uses/tradeoff/runs.h"

namespace coppermoon::verbs {

/// Trials as CSV, a row each; a cell is empty where the solver has no such setting.
std::string as_csv(std::span<const uses::Measured> all);

/// Trials as a table in Markdown, the settings in one cell.
std::string as_markdown(std::span<const uses::Measured> all);

/// Trials as a list; null where the solver has no such setting.
nlohmann::ordered_json as_json(std::span<const uses::Measured> all);

/// Plot of the umbra's error by seconds, a line for each sweep, a colour for each solver. Open symbols are
/// extrapolated, a star is the setting of Yapo and Cutler (2009).
uses::Plot as_plot(std::span<const uses::Measured> all);

}  // namespace coppermoon::verbs
