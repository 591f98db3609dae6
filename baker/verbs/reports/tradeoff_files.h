// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "uses/plot/plot.h"
#include "uses/tradeoff/runs.h"

namespace coppermoon::verbs {

/// Trials as CSV, one a row; a cell is empty where a solver has no such setting.
std::string as_csv(std::span<const uses::Measured> all);

/// Trials as a table in Markdown, the settings in one cell.
std::string as_markdown(std::span<const uses::Measured> all);

/// Trials as a JSON list; null where a solver has no such setting.
nlohmann::ordered_json as_json(std::span<const uses::Measured> all);

/// Plot of seconds against the umbra's error: a line per sweep, a colour per solver; open symbols are extrapolated, a
/// star is the paper's own setting.
uses::Plot as_plot(std::span<const uses::Measured> all);

}  // namespace coppermoon::verbs
