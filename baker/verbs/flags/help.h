// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// A flag as help shows it.
struct FlagText {
  std::string name;   ///< "output", without dashes
  std::string names;  ///< "-o, --output"
  std::string value;  ///< "FILE"; empty if it takes no value
  std::string text;   ///< meaning, allowed words and default
  std::string group;
  std::vector<std::string> words;  ///< allowed values, if they are words
  bool positional = false, required = false, many = false;
};

/// Flags of a command in the order of --help-all.
std::vector<FlagText> flag_texts(const Verb& verb);

/// Usage of a command: "still INSTANT -o FILE [options]".
std::string usage_of(const Verb& verb);

/// Text that --help prints for a command: its common flags (guide_to), and two examples.
std::string short_help(const Verb& verb);

/// Text that --help-all prints for a command: all its flags, by heading.
std::string full_help(const Verb& verb);

/// Text that --help prints for the program: its commands.
std::string program_help(const Program& program);

}  // namespace coppermoon::verbs
