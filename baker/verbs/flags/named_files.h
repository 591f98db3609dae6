// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "colour/working_space.h"
#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Whether a name has the ending of a file, as "film.mp4".
bool ends_as_a_file(const std::filesystem::path& name);

/// Colour space of a file that is written: as its name says, or as asked for; nothing where neither does.
///
/// Throws  algebra::Error  when they differ
std::optional<colour::WorkingSpace> space_for(const std::filesystem::path& file,
                                              std::optional<colour::WorkingSpace> asked);

/// Says on stderr which colour space a file is in, where its name seems to say another, as moon_aces.exr does.
///
/// Given  way_out  how it would be another; empty: it cannot
void say_space_of(const std::filesystem::path& file, colour::WorkingSpace space,
                  std::string_view way_out = {});

inline constexpr std::string_view other_spaces =
    "; --space, or a name with acescg or lin_ciexyzd65_scene, makes it another";

/// Refuses a command line by which one file would overwrite another, before any work is done.
///
/// Throws  algebra::Error  when a file that is written is also one that is read (the same file by any
///                         name or link), two that are written are one, or one that is read stands in
///                         a folder that is written; the recipe may stand there. When one that is
///                         read is no regular file. When a folder that is not there yet has a file's
///                         name
void require_files_apart(const Verb& verb);

}  // namespace coppermoon::verbs
