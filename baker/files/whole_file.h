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

/// Absolute path with all links followed, also those to what is not there yet.
std::filesystem::path place_of(const std::filesystem::path& path, std::error_code& failed);

/// Writes a file that appears whole or not at all: under a temporary name in the same folder, flushed to the disk,
/// then renamed. When the writing stops, the temporary file goes and an old file stays. A replaced file keeps its
/// permissions.
///
/// Given   path   of a file, new or to be replaced; a symbolic link is followed
///         fill   called with the new file, open for reading and writing; an exception ends the writing
/// Throws  Error  one line with the path: no such folder, not permitted, the disk full, a directory
void write_whole(const std::filesystem::path& path, const std::function<void(const Handle&)>& fill);

/// Writes a text whole or not at all.
void write_whole(const std::filesystem::path& path, std::string_view text);

/// Refuses a pipe, a device or any other file whose reading might wait, or never end.
///
/// Throws  Error  one line with the path, when the path is no regular file
void require_regular_file(const std::filesystem::path& path);

/// Refuses a path where no file can be written, before the work for it.
///
/// Throws  Error  when its folder, or that of a link's target, is missing, or it is a folder itself
void require_place_for(const std::filesystem::path& file);

/// All bytes of a regular file.
///
/// Throws  Error  one line with the path: no such file, not permitted, or as require_regular_file
std::string bytes_of(const std::filesystem::path& path);

/// First bytes of a file, at most `most_bytes`.
///
/// Throws  Error  one line with the path, when there is no such file, or as require_regular_file
std::string beginning_of(const std::filesystem::path& path, std::size_t most_bytes);

}  // namespace coppermoon::files
