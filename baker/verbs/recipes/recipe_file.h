// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Whether a file made by coppermoon holds its recipe, judging by its ending, or by its name in Stellarium's folder.
bool holds_recipe(const std::filesystem::path& path);

/// Sets a command's parameters from a recipe, which is a TOML file or is stored in a file made by coppermoon. Values
/// given on the command line itself take precedence. The table [atmosphere] holds parameters of the air, with
/// --atmosphere itself as `model` and regions as [[atmosphere.region]]; [camera] likewise. Keys of other commands are
/// ignored, so that one recipe serves all commands.
///
/// Throws    WrongUsage       for an unknown key, with the nearest known one, and for a value that is not one of the
///                            words allowed: "<file>:<line>: …"
///           algebra::Error   if the recipe cannot be read (request::recipe_in), or a value is not allowed:
///                            "<file>:<line>: …"
void take_recipe(Verb& verb, const std::string& path);

/// Says in one line on stderr if a file was made in the colours of a camera other than that of the response.
///
/// Given  response  camera response of the photograph or picture; if absent, any camera will do
void warn_of_another_camera(const std::string& file, const std::optional<std::string>& response);

}  // namespace coppermoon::verbs
