// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "verbs/flags.h"

namespace coppermoon::verbs {

/// All words of the command line, each with its flags.
void add_words(CLI::App& program);

/// Reads a command line, recipes put in, and does what it says.
///
/// Given   arguments  without the program's name
/// Throws  WrongUsage       when the usage is wrong: also for an argument that is not UTF-8, which
///                          neither a recipe nor JSON could hold
///         CLI::ParseError  when CLI11 finds it wrong, or for help
///         algebra::Error   when it cannot be done
void obey(CLI::App& program, const std::vector<std::string>& arguments);

}  // namespace coppermoon::verbs
