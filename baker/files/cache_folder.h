// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace coppermoon::files {

/// Makes a folder that only this user may enter. An existing folder is left as it is.
///
/// Throws  Error  if the folder cannot be made or belongs to another user
void make_private_folder(const std::filesystem::path& folder);

/// Folder in which baked textures are kept. The environment variable COPPERMOON_CACHE can name it; otherwise it is
/// `coppermoon` in the user's cache folder (XDG Base Directory Specification).
///
/// Throws  Error  if the user has no home folder
std::filesystem::path usual_cache();

/// Whether a folder is the one that usual_cache returns; false if the user has no home folder.
bool is_usual_cache(const std::filesystem::path& folder);

/// A file in a cache.
struct KeptFile {
  std::filesystem::path path;
  std::uintmax_t bytes;
  std::filesystem::file_time_type used;  ///< time at which it was last written or marked as used
};

/// Finds the textures in a cache. They are regular files of this user whose names are 16 hexadecimal digits and ".tx".
///
/// Returned  the textures, the most recently used first; empty if the folder does not exist
std::vector<KeptFile> kept_in(const std::filesystem::path& folder);

/// Records the present moment as a cached file's last use.
void mark_as_used(const std::filesystem::path& file);

/// Removes textures from a cache, the least recently used first, until at most `most_bytes` remain. Textures used after
/// `since` are never removed.
///
/// Returned  the removed textures
std::vector<KeptFile> remove_oldest(const std::filesystem::path& folder, double most_bytes,
                                    std::filesystem::file_time_type since);

/// Whether a path is a regular file, not a link, that belongs to this user or to root.
bool is_users_own(const std::filesystem::path& path);

}  // namespace coppermoon::files
