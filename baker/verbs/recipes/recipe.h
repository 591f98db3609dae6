// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// A command line with its recipes put in: `--recipe file.toml` (or a picture that coppermoon
/// made, by that flag or in the instant's place) becomes the flags it names, right behind the verb, so
/// that the user's own flags come later and win.
///
/// Given     arguments  without the program's name
/// Throws    WrongUsage       for a word, flag or recipe key there is not: names the nearest there
///                            is
///           algebra::Error   when a recipe cannot be read: "<file>:<line>: …"
std::vector<std::string> with_recipes(const CLI::App& program,
                                      const std::vector<std::string>& arguments);

/// The recipe that a command line names, by --recipe or in the instant's place; empty: none.
///
/// Given  arguments  as with_recipes takes them, which refuses what is wrong with them
std::string recipe_named_in(const CLI::App& program, const std::vector<std::string>& arguments);

/// Recipe of a verb's flags, those given and the defaults of all others, as request::recipe_of has it.
std::string recipe_of(const CLI::App& verb);

/// The option that takes a recipe; read by with_recipes before any other.
void add_recipe_option(CLI::App& verb);

}  // namespace coppermoon::verbs
