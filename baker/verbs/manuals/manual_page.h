// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Manual page for a command (section 1), in roff with the macros of man(7). It has everything that --help-all lists.
std::string manual_page(const Verb& verb);

/// Manual page for the program. It describes the commands, the exit status and the files.
std::string program_manual_page(const Program& program);

}  // namespace coppermoon::verbs
