// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace coppermoon::request {

/// Number of letters to insert, drop or change to turn one word into another (the Levenshtein distance).
std::size_t letters_apart(std::string_view a, std::string_view b);

/// The known word that is most similar to the given word, by the number of letters to change (letters_apart).
///
/// Given  known  at least one word
std::string nearest(std::string_view word, const std::vector<std::string>& known);

}  // namespace coppermoon::request
