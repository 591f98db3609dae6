// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Names of all flags of a command, without dashes.
std::vector<std::string> names_of(const Verb& verb);

bool holds(const std::vector<std::string>& words, std::string_view word);

/// Advice on what replaces a flag or recipe key that existed in earlier versions, such as "photons are no longer
/// marched; …". Empty if no earlier version had a flag or key of this name.
std::string_view since_there_is_no(std::string_view flag);

/// Suggestion for an unknown flag, such as "; did you mean --field?". It names the flag for which other programs use
/// the unknown name, or else a flag with almost the same spelling. Empty if there is neither.
std::string flag_suggested_for(std::string_view flag, const std::vector<std::string>& known);

/// Suggestion for an unknown command, such as "; did you mean still?". Empty if there is none.
std::string verb_suggested_for(std::string_view verb, const std::vector<std::string>& known);

}  // namespace coppermoon::verbs
