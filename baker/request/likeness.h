// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace coppermoon::request {

/// Number of letters to insert, drop or change to turn one word into the other (Levenshtein).
std::size_t letters_apart(std::string_view a, std::string_view b);

/// The known word that the fewest letters to insert, drop or change separate from `word` (Levenshtein).
///
/// Given  known  at least one word
std::string nearest(std::string_view word, const std::vector<std::string>& known);

}  // namespace coppermoon::request
