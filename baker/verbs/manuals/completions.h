// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Scripts by which a shell completes commands, options, options' words and files.
std::string bash_completion(const Program& program);
std::string zsh_completion(const Program& program);
std::string fish_completion(const Program& program);

}  // namespace coppermoon::verbs
