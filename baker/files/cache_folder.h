// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace coppermoon::files {

/// Makes a folder that only this user may enter, unless it exists already.
///
/// Throws  Error  if it cannot be made, or belongs to another user
void make_private_folder(const std::filesystem::path& folder);

/// Folder in which baked textures are kept: the one that the variable COPPERMOON_CACHE names, else `coppermoon` in the
/// user's cache folder (XDG Base Directory Specification).
///
/// Throws  Error  if the user has no home folder
std::filesystem::path usual_cache();

/// Whether a folder is the usual cache; false if there is no usual cache.
bool is_usual_cache(const std::filesystem::path& folder);

/// A file in a cache.
struct KeptFile {
  std::filesystem::path path;
  std::uintmax_t bytes;
  std::filesystem::file_time_type used;  ///< when it was last marked as used, or written
};

/// Textures in a cache: this user's regular files with names of 16 hexadecimal digits and ".tx". Empty if the folder
/// does not exist.
///
/// Returned  the textures, the most recently used first
std::vector<KeptFile> kept_in(const std::filesystem::path& folder);

/// Marks a file in a cache as used now.
void mark_as_used(const std::filesystem::path& file);

/// Removes files from a cache, the least recently used first, until at most `most_bytes` remain. Files used after
/// `since` are never removed.
///
/// Returned  the removed files
std::vector<KeptFile> remove_oldest(const std::filesystem::path& folder, double most_bytes,
                                    std::filesystem::file_time_type since);

/// Whether a path is a regular file, not a link, that belongs to this user or to root.
bool is_users_own(const std::filesystem::path& path);

}  // namespace coppermoon::files
