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

/// The absolute path to which a path leads when all links are followed, even a link to a file that does not exist yet.
std::filesystem::path place_of(const std::filesystem::path& path, std::error_code& failed);

/// Writes a file that appears whole or not at all. It gets its final name only after it has been written to the disk.
/// If writing fails, nothing new remains and a previous file stays as it was. A file that replaces another keeps that
/// file's permissions.
///
/// Given   path   of a new file or of one to replace; a symbolic link is followed
///         fill   called with the new file, open for reading and writing; if it throws, the file is not made
/// Throws  Error  one line with the path, if there is no such folder, the path is a directory, the disk is full, or
///                writing is not permitted
void write_whole(const std::filesystem::path& path, const std::function<void(const Handle&)>& fill);

/// Writes text to a file that appears whole or not at all.
void write_whole(const std::filesystem::path& path, std::string_view text);

/// On Windows, throws if no file can have this name, such as `a:b`, `con.exr` or a name that ends in a dot or a space.
///
/// Throws  Error
void require_possible_name(const std::filesystem::path& path);

/// Reason why Windows does not allow a name for a file or folder; empty if the name is allowed.
std::string_view why_not_on_windows(std::string_view name);

/// Throws if a path is a pipe, a device or any other file from which reading might block or never end.
///
/// Throws  Error  one line with the path, if it exists but is not a regular file
void require_regular_file(const std::filesystem::path& path);

/// Throws if no file could be written at a path. Call this before computing what is to be written.
///
/// Throws  Error  if the folder of the file (or of a link's target) is missing, if the path itself is a folder, or if
///                the system allows no such name
void require_place_for(const std::filesystem::path& file);

/// All bytes of a regular file.
///
/// Throws  Error  one line with the path, if the file does not exist, is not regular or cannot be read
std::string bytes_of(const std::filesystem::path& path);

/// The first bytes of a regular file, at most `most_bytes` of them.
///
/// Throws  Error  one line with the path, if the file does not exist, is not regular or cannot be read
std::string beginning_of(const std::filesystem::path& path, std::size_t most_bytes);

}  // namespace coppermoon::files
