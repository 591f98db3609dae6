// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace coppermoon::request {

/// Number of letters to insert, drop or change to make one word of the other (Levenshtein).
std::size_t letters_apart(std::string_view a, std::string_view b);

/// Word of those known that takes the fewest letters to insert, drop or change (Levenshtein).
///
/// Given  known  one or more
std::string nearest(std::string_view word, const std::vector<std::string>& known);

}  // namespace coppermoon::request
