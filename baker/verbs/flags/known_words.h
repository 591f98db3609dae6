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

/// Advice on what replaces a flag or recipe key from earlier versions, such as "photons are no longer marched; …".
/// Empty if there never was one with that name.
std::string_view since_there_is_no(std::string_view flag);

/// Suggestion for an unknown flag, such as "; did you mean --field?": the flag for what other programs call by that
/// name, or one with almost the same spelling. Empty if there is neither.
std::string flag_suggested_for(std::string_view flag, const std::vector<std::string>& known);

/// Suggestion for an unknown command, such as "; did you mean still?".
std::string verb_suggested_for(std::string_view verb, const std::vector<std::string>& known);

}  // namespace coppermoon::verbs
