// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

namespace coppermoon::verbs {

/// Flags that say where results go and how they are told: a texture's header holds none of them, and
/// those that a stranger's header holds are passed over.
std::vector<std::string> no_part_of_recipes();

/// The flags that a recipe names, a TOML file or the header of an .exr that coppermoon made. The
/// table [atmosphere] holds flags of the Earth's air, its own called `model`, and regions as
/// [[atmosphere.region]].
///
/// Given     mine  the user's own arguments; what they name is left out of the recipe's
/// Returned  "--flag=value", in the order of the alphabet, those in [atmosphere] last
/// Throws    CLI::ParseError  for a key there is not: "<file>:<line>: …", with the nearest there is
///           algebra::Error   when the recipe cannot be read: "<file>:<line>: …"; when it has
///                            more than 1 MiB, a text with a zero byte, or a name of 17 parts
std::vector<std::string> flags_of_recipe(const CLI::App& verb, const std::string& path,
                                         const std::vector<std::string>& mine);

}  // namespace coppermoon::verbs
