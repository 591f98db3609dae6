// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// A flag as a reader sees it.
struct FlagText {
  std::string name;   ///< "output", without dashes
  std::string names;  ///< "-o, --output"
  std::string value;  ///< "FILE"; empty: takes none
  std::string text;   ///< what it is, the words allowed, the default
  std::string group;
  std::vector<std::string> words;  ///< allowed values, where they are words
  bool positional = false, required = false;
};

/// The flags of a verb that --help-all lists, in their order.
std::vector<FlagText> flag_texts(const CLI::App& verb);

/// "still INSTANT -o FILE [options]".
std::string usage_of(const CLI::App& verb);

/// What --help prints for a verb: its common flags (guide_to), and two examples.
std::string short_help(const CLI::App& verb);

/// What --help-all prints for a verb: all its flags, in groups.
std::string full_help(const CLI::App& verb);

/// What --help prints for the program: its verbs.
std::string program_help(const CLI::App& program);

/// The help that a command line calls for.
///
/// Given  program  parsed until the help was met
///        all      by --help-all
std::string help_called_for(const CLI::App& program, bool all);

}  // namespace coppermoon::verbs
