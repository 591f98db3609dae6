// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace coppermoon::verbs {

/// A number with one of some endings, "" last where it needs none.
///
/// Given     units  each with what it multiplies by
/// Returned  nothing when the text is no such number
std::optional<double> number_with_unit(const std::string& text,
                                       const std::vector<std::pair<std::string, double>>& units);

}  // namespace coppermoon::verbs
