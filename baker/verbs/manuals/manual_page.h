// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// The manual page for one command, section 1, in roff with the macros of man(7). It covers everything that
/// --help-all lists.
std::string manual_page(const Verb& verb);

/// The manual page for the program: its commands, exit status and files.
std::string program_manual_page(const Program& program);

}  // namespace coppermoon::verbs
