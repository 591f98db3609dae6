// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Whether a file is one that coppermoon made, by its ending, or by its name in Stellarium's folder: it holds
/// its recipe.
bool holds_recipe(const std::filesystem::path& path);

/// The flags that a recipe names, a TOML file or what a file that coppermoon
/// made holds. The
/// table [atmosphere] holds flags of the Earth's air, its own called `model`, and regions as
/// [[atmosphere.region]]. Keys that another verb knows are passed over: one recipe serves all verbs.
///
/// Given     mine  the user's own arguments; what they name is left out of the recipe's
/// Returned  "--flag=value", in the order of the alphabet, those in [atmosphere] last
/// Throws    WrongUsage       for a key there is not: "<file>:<line>: …", with the nearest there is
///           algebra::Error   when the recipe cannot be read: "<file>:<line>: …"; when it has
///                            more than 1 MiB, a text with a zero byte, or a name of 17 parts
std::vector<std::string> flags_of_recipe(const CLI::App& verb, const std::string& path,
                                         const std::vector<std::string>& mine);

}  // namespace coppermoon::verbs
