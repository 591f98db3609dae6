// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "verbs/tradeoff_runs.h"

namespace coppermoon::verbs {

/// A row for each, empty where a solver has no such setting.
std::string as_csv(std::span<const Measured> all);

/// A table of them, the settings in one cell.
std::string as_markdown(std::span<const Measured> all);

/// A list of them; null where a solver has no such setting.
nlohmann::ordered_json as_json(std::span<const Measured> all);

/// Seconds against the umbra's error, for gnuplot: a line for each sweep, a colour for each solver;
/// open symbols are extrapolated, a star is the paper's own setting.
std::string as_plot(std::span<const Measured> all);

}  // namespace coppermoon::verbs
