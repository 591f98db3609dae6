// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Whether a file is one of coppermoon's that holds its recipe, by its ending, or by its name in Stellarium's folder.
bool holds_recipe(const std::filesystem::path& path);

/// Gives a command's parameters the values of a recipe, which is a TOML file or stands in a file of coppermoon's, but for
/// those that the command line gives itself. The table [atmosphere] holds parameters of the air, --atmosphere itself as
/// `model`, and regions as [[atmosphere.region]]; [camera] likewise. Keys of other commands are passed over: one recipe
/// serves all.
///
/// Throws    WrongUsage       for a key there is not, with the nearest there is, and for a value that is none of those
///                            allowed: "<file>:<line>: …"
///           algebra::Error   when the recipe cannot be read (request::recipe_in), or a value is not allowed:
///                            "<file>:<line>: …"
void take_recipe(Verb& verb, const std::string& path);

/// Says on stderr, in one line, where a file was made in the colours of another camera than a response is.
///
/// Given  response  of the photograph or picture; none: any
void warn_of_another_camera(const std::string& file, const std::optional<std::string>& response);

}  // namespace coppermoon::verbs
