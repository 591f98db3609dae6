// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace coppermoon::algebra {

/// Reads a number from a text such as "1.5", "-2e-3" or "+20"; also "inf" and "nan", which require_within refuses.
///
/// Returned  empty if the text is anything else, or the number does not fit a double
std::optional<double> number_in(std::string_view text);

/// Reads a whole number of at most nine digits, without a sign.
std::optional<std::size_t> whole_number(std::string_view text);

/// A text without the blanks at its ends.
std::string_view without_spaces(std::string_view text);

/// Reads a number from a text that ends in one of several units.
///
/// Given     units  each with its factor; if a number without a unit is allowed, "" comes last
/// Returned  empty if the text is not such a number
std::optional<double> number_with_unit(
    std::string_view text, const std::vector<std::pair<std::string_view, double>>& units);

/// Reads the numbers in a text that are separated by commas, as in "450,550.5".
///
/// Returned  an empty list for an empty text; empty if a part is not a number
std::optional<std::vector<double>> numbers_in(std::string_view text);

}  // namespace coppermoon::algebra
