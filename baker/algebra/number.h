// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace coppermoon::algebra {

/// The number that a text spells, as "1.5", "-2e-3" or "+20"; also "inf" and "nan", which ranges
/// refuse by name (require_within).
///
/// Returned  nothing when the text is anything else, or beyond what a double holds
std::optional<double> number_in(std::string_view text);

/// A number with one of some endings, "" last where it needs none.
///
/// Given     units  each with what it multiplies by
/// Returned  nothing when the text is no such number
std::optional<double> number_with_unit(
    std::string_view text, const std::vector<std::pair<std::string_view, double>>& units);

/// Numbers with commas between, as "450,550.5".
///
/// Returned  an empty list for an empty text; nothing when a part is no number
std::optional<std::vector<double>> numbers_in(std::string_view text);

}  // namespace coppermoon::algebra
