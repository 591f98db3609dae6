// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Names of a verb's flags, without their dashes.
std::vector<std::string> long_flags(const CLI::App& verb);

/// The names, without their dashes, of the flags that a function adds to a verb.
std::vector<std::string> flags_added_by(const std::function<void(CLI::App&)>& add);

bool holds(const std::vector<std::string>& words, std::string_view word);

/// Number of letters to insert, drop or change to make one word of the other (Levenshtein).
std::size_t letters_apart(std::string_view a, std::string_view b);

/// The word of those known that takes the fewest letters to insert, drop or change (Levenshtein).
///
/// Given  known  one or more
std::string nearest(std::string_view word, const std::vector<std::string>& known);

/// "; did you mean --field?": a flag that means what an unknown one does elsewhere, or is spelt almost
/// alike. Empty where there is none.
std::string flag_suggested_for(std::string_view flag, const std::vector<std::string>& known);

/// The same for a verb: "; did you mean still?".
std::string verb_suggested_for(std::string_view verb, const std::vector<std::string>& known);

}  // namespace coppermoon::verbs
