// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "colour/working_space.h"
#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Whether a name has the ending of a known file format, such as "film.mp4".
bool ends_as_a_file(const std::filesystem::path& name);

/// Colour space for a file to write. It is the one that the file's name contains, else the requested one, if any.
///
/// Throws  algebra::Error  if the file's name contains another colour space than the requested one
std::optional<colour::WorkingSpace> space_for(const std::filesystem::path& file,
                                              std::optional<colour::WorkingSpace> asked);

/// Reports on stderr which colour space a file has if its name, such as moon_aces.exr, suggests another.
///
/// Given  way_out  advice on how to get another colour space; empty if there is no other
void say_space_of(const std::filesystem::path& file, colour::WorkingSpace space,
                  std::string_view way_out = {});

inline constexpr std::string_view other_spaces =
    "; --space, or a name with acescg or lin_ciexyzd65_scene, makes it another";

/// Checks, before any work is done, that no file named on the command line would overwrite another.
///
/// Throws  algebra::Error  if a file to write is also to be read (by any name or link); if two files to write are the
///                         same; if a file to read, other than the recipe, lies in a folder to write; if a file to read
///                         is not a regular file; or if a new folder's name ends like that of a file
void require_files_apart(const Verb& verb);

}  // namespace coppermoon::verbs
