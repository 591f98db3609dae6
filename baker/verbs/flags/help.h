// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// A flag as the help shows it.
struct FlagText {
  std::string name;   ///< name without dashes, such as "output"
  std::string names;  ///< all spellings, such as "-o, --output"
  std::string value;  ///< kind of value, such as "FILE"; empty for a flag without a value
  std::string text;   ///< the flag's meaning, allowed words and default
  std::string group;
  std::vector<std::string> words;  ///< allowed values, if they are words
  bool positional = false, required = false, many = false;
};

/// The flags of a command, in the order in which --help-all lists them.
std::vector<FlagText> flag_texts(const Verb& verb);

/// Usage line of a command, such as "still INSTANT -o FILE [options]".
std::string usage_of(const Verb& verb);

/// Text that --help prints for a command. It lists the command's common flags (guide_to) and two examples.
std::string short_help(const Verb& verb);

/// Text that --help-all prints for a command. It lists all flags, grouped under headings.
std::string full_help(const Verb& verb);

/// Text that --help prints for the program. It lists the commands.
std::string program_help(const Program& program);

}  // namespace coppermoon::verbs
