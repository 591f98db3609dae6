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
/// stays.
///
/// Given   path   of a file, new or to be replaced; a symbolic link is followed
///         fill   told a file descriptor open for writing; whatever it throws ends the writing
/// Throws  Error  one line with the path: no such folder, not permitted, the disk full, a directory
void write_whole(const std::filesystem::path& path, const std::function<void(int)>& fill);

/// The same for text.
void write_whole(const std::filesystem::path& path, std::string_view text);

/// Refuses what would not end or not come, as a pipe or device.
///
/// Throws  Error  one line with the path, when something that is no regular file is there
void require_regular_file(const std::filesystem::path& path);

/// All bytes of a regular file.
///
/// Throws  Error  one line with the path: no such file, not permitted, or as require_regular_file
std::string bytes_of(const std::filesystem::path& path);

/// A file's bytes, or the first of them: what has no end takes no more memory than that.
///
/// Throws  Error  one line with the path, when there is no such file, or as require_regular_file
std::string beginning_of(const std::filesystem::path& path, std::size_t most_bytes);

}  // namespace coppermoon::files
