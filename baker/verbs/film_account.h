// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "texture/image.h"

namespace coppermoon::verbs {

struct Film;

/// What a file was made from, in lines as a recipe's: the program's version, fingerprints of the albedo
/// map and of the view, and the recipe.
using Account = std::string;

Account account_of(const Film& film);

/// The account as a file's header keeps it.
texture::Attributes account_attributes(const Film& film);

/// The account that a file's header keeps; empty without a recipe.
///
/// Throws  Error  when it is no image
Account account_in(const std::filesystem::path& file);

/// Of all lines those that the light of a film depends on.
Account of_light(const Account& account);

/// Those that a linear frame's pixels depend on: all but its exposure and its picture.
Account of_scene(const Account& account);

/// Those that a file depends on, by its name: a texture has no camera.
Account of_file(const std::filesystem::path& file, const Account& account);

/// What two accounts differ in, for whoever asked for the second: "iso = 800, asked 100; …". Empty: in
/// nothing.
std::string differences(const Account& there, const Account& asked);

}  // namespace coppermoon::verbs
