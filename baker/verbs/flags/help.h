// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Flag as help shows it.
struct FlagText {
  std::string name;   ///< "output", without dashes
  std::string names;  ///< "-o, --output"
  std::string value;  ///< "FILE"; empty: takes none
  std::string text;   ///< meaning, words allowed, default
  std::string group;
  std::vector<std::string> words;  ///< allowed values, where they are words
  bool positional = false, required = false;
};

/// Flags of a command in the order of --help-all.
std::vector<FlagText> flag_texts(const CLI::App& verb);

/// Usage of a command: "still INSTANT -o FILE [options]".
std::string usage_of(const CLI::App& verb);

/// Text of --help of a command: its common flags (guide_to), and two examples.
std::string short_help(const CLI::App& verb);

/// Text of --help-all of a command: all its flags, by heading.
std::string full_help(const CLI::App& verb);

/// Text of --help of the program: its commands.
std::string program_help(const CLI::App& program);

/// Help that a command line asks for.
///
/// Given  program  parsed until the help was met
///        all      by --help-all
std::string help_called_for(const CLI::App& program, bool all);

}  // namespace coppermoon::verbs
