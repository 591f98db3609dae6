// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Scripts with which bash, zsh and fish complete commands, options, the words that options accept, and file names.
std::string bash_completion(const Program& program);
std::string zsh_completion(const Program& program);
std::string fish_completion(const Program& program);

}  // namespace coppermoon::verbs
