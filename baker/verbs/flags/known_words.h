// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Names of a command's flags, without their dashes.
std::vector<std::string> names_of(const Verb& verb);

bool holds(const std::vector<std::string>& words, std::string_view word);

/// What to do now, as "photons are no longer marched; …", in place of a flag or recipe's key of earlier versions. Empty:
/// there was none of that name.
std::string_view since_there_is_no(std::string_view flag);

/// Suggestion for an unknown flag, as "; did you mean --field?": the flag that other programs call so, or one that is
/// spelt almost alike. Empty: none.
std::string flag_suggested_for(std::string_view flag, const std::vector<std::string>& known);

/// Suggestion for an unknown command, as "; did you mean still?".
std::string verb_suggested_for(std::string_view verb, const std::vector<std::string>& known);

}  // namespace coppermoon::verbs
