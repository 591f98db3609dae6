// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace coppermoon::algebra {

/// Reads a number such as "1.5", "-2e-3" or "+20". It also accepts "inf" and "nan", which require_within then refuses.
///
/// Returned  nullopt if the text is anything else, or if the number does not fit into a double
std::optional<double> number_in(std::string_view text);

/// Reads a whole number of at most nine digits, without a sign.
std::optional<std::size_t> whole_number(std::string_view text);

/// The text without leading and trailing spaces.
std::string_view without_spaces(std::string_view text);

/// Reads a number with a unit, such as "10min", and multiplies the number by the factor of that unit.
///
/// Given     units  allowed units, each with its factor; the last one is "" if the unit may be missing
/// Returned  nullopt if the text is not such a number
std::optional<double> number_with_unit(
    std::string_view text, const std::vector<std::pair<std::string_view, double>>& units);

/// Reads numbers that are separated by commas, such as "450,550.5".
///
/// Returned  an empty list if the text is empty; nullopt if any part between commas is not a number
std::optional<std::vector<double>> numbers_in(std::string_view text);

}  // namespace coppermoon::algebra
