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

bool holds(const std::vector<std::string>& words, std::string_view word);

/// "; did you mean --field?": a flag that means what an unknown one does elsewhere, or is spelt almost
/// alike. Empty where there is none.
std::string flag_suggested_for(std::string_view flag, const std::vector<std::string>& known);

/// The same for a verb: "; did you mean still?".
std::string verb_suggested_for(std::string_view verb, const std::vector<std::string>& known);

}  // namespace coppermoon::verbs
