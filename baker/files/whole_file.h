// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <system_error>

#include "files/handle.h"

namespace coppermoon::files {

/// Absolute path with all links followed, even links to something that does not exist yet.
std::filesystem::path place_of(const std::filesystem::path& path, std::error_code& failed);

/// Writes a file that appears whole or not at all: it is written under a temporary name in the same folder, flushed to
/// the disk, then renamed. If writing fails, the temporary file is removed and an old file stays. A file that replaces
/// another takes over its permissions.
///
/// Given   path   path of a new file or of one to replace; a symbolic link is followed
///         fill   called with the new file, open for reading and writing; an exception ends the writing
/// Throws  Error  one line with the path: no such folder, not permitted, disk full, or a directory
void write_whole(const std::filesystem::path& path, const std::function<void(const Handle&)>& fill);

/// Writes a text whole or not at all.
void write_whole(const std::filesystem::path& path, std::string_view text);

/// Refuses a pipe, a device or any other file from which reading might block or never end.
///
/// Throws  Error  one line with the path, if it is not a regular file
void require_regular_file(const std::filesystem::path& path);

/// Refuses a path at which no file can be written, before the work for that file begins.
///
/// Throws  Error  if its folder or that of a link's target is missing, or if the path is a folder itself
void require_place_for(const std::filesystem::path& file);

/// All bytes of a regular file.
///
/// Throws  Error  one line with the path: no such file, not permitted, or as require_regular_file
std::string bytes_of(const std::filesystem::path& path);

/// First bytes of a file, at most `most_bytes`.
///
/// Throws  Error  one line with the path, if there is no such file, or as require_regular_file
std::string beginning_of(const std::filesystem::path& path, std::size_t most_bytes);

}  // namespace coppermoon::files
