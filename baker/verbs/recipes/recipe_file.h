// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Whether a file is of a kind that holds the recipe by which it was made. The kind is recognised by the ending of the
/// file's name or, in a folder for Stellarium, by the whole name.
bool holds_recipe(const std::filesystem::path& path);

/// Sets a command's parameters from a recipe. The recipe is a TOML file, or is stored in a file made by coppermoon.
/// Values given on the command line take precedence. The table [atmosphere] holds the parameters of the air, with the
/// value of --atmosphere under the key `model`, and regions as [[atmosphere.region]]. The table [camera] is built in
/// the same way. Keys that belong to other commands are ignored, so that all commands can use the same recipe.
///
/// Throws    WrongUsage       for an unknown key, with the nearest known one, and for a word that is not allowed. The
///                            message begins with "<file>:<line>: "
///           algebra::Error   if the recipe cannot be read (request::recipe_in), or another value is not allowed. The
///                            message begins with "<file>:<line>: "
void take_recipe(Verb& verb, const std::string& path);

/// Warns on stderr if a file was made with the response of another camera, so that its colours differ.
///
/// Given  response  camera response that the file should have; if absent, any will do
void warn_of_another_camera(const std::string& file, const std::optional<std::string>& response);

}  // namespace coppermoon::verbs
