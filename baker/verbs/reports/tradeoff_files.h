// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "uses/plot/plot.h"
#include "uses/tradeoff/runs.h"

namespace coppermoon::verbs {

/// Trials as CSV: a row for each, a cell empty where a solver has no such setting.
std::string as_csv(std::span<const uses::Measured> all);

/// Trials as a table in Markdown, the settings in one cell.
std::string as_markdown(std::span<const uses::Measured> all);

/// Trials as a list; null where a solver has no such setting.
nlohmann::ordered_json as_json(std::span<const uses::Measured> all);

/// Seconds against the umbra's error, as a plot: a line for each sweep, a colour for each solver;
/// open symbols are extrapolated, a star is the paper's own setting.
uses::Plot as_plot(std::span<const uses::Measured> all);

}  // namespace coppermoon::verbs
