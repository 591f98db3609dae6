// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Type names of flags that name files, in help and for the rules below.
inline constexpr const char *read_file = "FILE", *written_file = "NEW-FILE",
                            *written_folder = "FOLDER";

/// Whether a flag names a file or folder that is written: no recipe may hold it.
bool says_where_results_go(const CLI::Option& flag);

/// Whether a name has the ending of a file, as "film.mp4".
bool ends_as_a_file(const std::filesystem::path& name);

/// Refuses a command line by which one file would overwrite another, before any work is done.
///
/// Throws  algebra::Error  when a file that is written is also one that is read (the same file by any
///                         name or link), two that are written are one, or one that is read stands in
///                         a folder that is written; the recipe may stand there. When one that is
///                         read is no regular file. When a folder that is not there yet has a file's
///                         name
void require_files_apart(const CLI::App& verb);

}  // namespace coppermoon::verbs
