// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace coppermoon::verbs {

/// A word that nobody knows, on the command line or in a recipe: exit status 2.
struct UnknownWord : CLI::ParseError {
  explicit UnknownWord(const std::string& text)
      : CLI::ParseError("UnknownWord", text, CLI::ExitCodes::ExtrasError) {}
};

/// Names of a verb's flags, without their dashes.
std::vector<std::string> long_flags(const CLI::App& verb);

bool holds(const std::vector<std::string>& words, std::string_view word);

/// The word of those known that takes the fewest letters to insert, drop or change (Levenshtein).
///
/// Given  known  one or more
std::string nearest(std::string_view word, const std::vector<std::string>& known);

}  // namespace coppermoon::verbs
