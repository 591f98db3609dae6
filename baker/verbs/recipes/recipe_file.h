// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Whether a file is one of coppermoon's that holds its recipe, by its ending, or by its name in Stellarium's folder.
bool holds_recipe(const std::filesystem::path& path);

/// Flags of a recipe, which is a TOML file or stands in a file of coppermoon's. The table [atmosphere] holds parameters
/// of the air, --atmosphere itself as `model`, and regions as [[atmosphere.region]]; [camera] likewise. Keys of other
/// commands are passed over: one recipe serves all.
///
/// Given     mine  the user's own arguments: flags that they name are left out of the recipe's
/// Returned  "--flag=value", in the order of the alphabet, those in [atmosphere] last
/// Throws    WrongUsage       for a key there is not: "<file>:<line>: …", with the nearest there is
///           algebra::Error   when the recipe cannot be read: "<file>:<line>: …"; when it has
///                            more than 1 MiB, a text with a zero byte, or a name of 17 parts
std::vector<std::string> flags_of_recipe(const CLI::App& verb, const std::string& path,
                                         const std::vector<std::string>& mine);

/// Says on stderr, in one line, where a file was made in the colours of another camera than a response is.
///
/// Given  response  of the photograph or picture; none: any
void warn_of_another_camera(const std::string& file, const std::optional<std::string>& response);

}  // namespace coppermoon::verbs
