// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace coppermoon::algebra {

/// Number in a text, as "1.5", "-2e-3" or "+20"; also "inf" and "nan", which require_within refuses by name.
///
/// Returned  none when the text is anything else, or exceeds a double
std::optional<double> number_in(std::string_view text);

/// Whole number of at most nine digits, without a sign.
std::optional<std::size_t> whole_number(std::string_view text);

/// Text without the blanks at its ends.
std::string_view without_spaces(std::string_view text);

/// Number in a text that ends in one of some units.
///
/// Given     units  each with its factor; "" comes last, where a number without a unit is allowed
/// Returned  none when the text is no such number
std::optional<double> number_with_unit(
    std::string_view text, const std::vector<std::pair<std::string_view, double>>& units);

/// Numbers in a text that are separated by commas, as "450,550.5".
///
/// Returned  an empty list for an empty text; none when a part is no number
std::optional<std::vector<double>> numbers_in(std::string_view text);

}  // namespace coppermoon::algebra
