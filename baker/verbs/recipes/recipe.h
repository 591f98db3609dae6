// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
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

/// All that a verb was told, and the defaults of all it was not, as TOML: its own recipe. Where
/// results go is no part of it, and files that are read have their names to share (files::name_to_share).
///
/// Throws  algebra::Error  when a region cannot be understood
std::string recipe_of(const CLI::App& verb);

/// A recipe without some of the flags that stand above its tables.
std::string without(const std::string& recipe,
                    const std::function<bool(const std::string& flag)>& dropped);

/// What two recipes say otherwise: a flag, and its value in each, "none" where one says nothing.
struct RecipeDifference {
  std::string flag, first, second;
};

/// Flags in the order of the first recipe, then those of the second alone. All regions of the air count
/// as one value: that of "regions".
std::vector<RecipeDifference> recipe_differences(const std::string& first,
                                                 const std::string& second);

/// A recipe with a texture's width in place of any that it has.
std::string with_width(const std::string& recipe, std::size_t width);

/// The option that takes a recipe; read by with_recipes before any other.
void add_recipe_option(CLI::App& verb);

}  // namespace coppermoon::verbs
