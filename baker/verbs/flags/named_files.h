// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "colour/working_space.h"
#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Whether a name ends like that of a file, such as "film.mp4".
bool ends_as_a_file(const std::filesystem::path& name);

/// Colour space for a file to write, as its name says or as asked for; nothing if neither gives one.
///
/// Throws  algebra::Error  if the two differ
std::optional<colour::WorkingSpace> space_for(const std::filesystem::path& file,
                                              std::optional<colour::WorkingSpace> asked);

/// Says on stderr which colour space a file is in if its name, such as moon_aces.exr, suggests another.
///
/// Given  way_out  advice on how to get another space; empty if that is impossible
void say_space_of(const std::filesystem::path& file, colour::WorkingSpace space,
                  std::string_view way_out = {});

inline constexpr std::string_view other_spaces =
    "; --space, or a name with acescg or lin_ciexyzd65_scene, makes it another";

/// Refuses a command line with which one file would overwrite another, before any work is done.
///
/// Throws  algebra::Error  if a file to write is also to be read (by any name or link), if two files to write are the
///                         same, if a file to read other than the recipe lies in a folder to write, if a file to read
///                         is not a regular file, or if a new folder has a name like a file's
void require_files_apart(const Verb& verb);

}  // namespace coppermoon::verbs
