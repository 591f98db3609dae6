// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Command line in which the recipe is replaced by its flags, right behind the command: the user's own flags come later
/// and win. The recipe is the file of --recipe, or a picture of coppermoon's in the instant's place.
///
/// Given     arguments  without the program's name
/// Throws    WrongUsage       for a word, flag or recipe key there is not: names the nearest there
///                            is
///           algebra::Error   when a recipe cannot be read: "<file>:<line>: …"
std::vector<std::string> with_recipes(const CLI::App& program,
                                      const std::vector<std::string>& arguments);

/// File of the recipe that a command line names, by --recipe or in the instant's place; empty: none.
///
/// Given  arguments  as with_recipes takes them, which refuses what is wrong with them
std::string recipe_named_in(const CLI::App& program, const std::vector<std::string>& arguments);

/// Recipe of a command's parameters, given or by default (request::recipe_of).
std::string recipe_of(const CLI::App& verb);

/// Adds --recipe, which with_recipes reads before any other flag.
void add_recipe_option(CLI::App& verb);

}  // namespace coppermoon::verbs
