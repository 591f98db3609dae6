// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace coppermoon::files {

/// Writes a file that appears whole or not at all: under a temporary name in the same folder,
/// flushed to the disk, then renamed. Whatever stops it, the temporary file goes and the old file
/// stays. One that is replaced keeps its permissions.
///
/// Given   path   of a file, new or to be replaced; a symbolic link is followed
///         fill   told a file descriptor open for writing; whatever it throws ends the writing
/// Throws  Error  one line with the path: no such folder, not permitted, the disk full, a directory
void write_whole(const std::filesystem::path& path, const std::function<void(int)>& fill);

/// The same for text.
void write_whole(const std::filesystem::path& path, std::string_view text);

/// Refuses a pipe, a device or any other file that reading might wait for, or never come to the end
/// of.
///
/// Throws  Error  one line with the path, when something that is no regular file is there
void require_regular_file(const std::filesystem::path& path);

/// Refuses a place where no file could be put, before the work is done for it.
///
/// Throws  Error  when its folder is missing, or it is a folder itself
void require_place_for(const std::filesystem::path& file);

/// All bytes of a regular file.
///
/// Throws  Error  one line with the path: no such file, not permitted, or as require_regular_file
std::string bytes_of(const std::filesystem::path& path);

/// The first bytes of a file, at most `most_bytes`: a file that has no end takes no more memory
/// than that.
///
/// Throws  Error  one line with the path, when there is no such file, or as require_regular_file
std::string beginning_of(const std::filesystem::path& path, std::size_t most_bytes);

}  // namespace coppermoon::files
