// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace coppermoon::files {

/// Makes a folder that its user alone may enter, unless it is there already.
///
/// Throws  Error  when it cannot be made, or belongs to another user
void make_private_folder(const std::filesystem::path& folder);

/// Folder in which baked textures are kept: that of the variable COPPERMOON_CACHE, or `coppermoon` in the user's folder
/// of caches, as the XDG Base Directory Specification has it.
///
/// Throws  Error  when the user has no home
std::filesystem::path usual_cache();

/// Whether a folder is that one; false where there is none.
bool is_usual_cache(const std::filesystem::path& folder);

/// File that is kept in a cache.
struct KeptFile {
  std::filesystem::path path;
  std::uintmax_t bytes;
  std::filesystem::file_time_type used;  ///< when it was last used, of files marked as used
};

/// Textures in a cache: regular files of this user with names of 16 hexadecimal digits and ".tx"; none where there is
/// no folder.
///
/// Returned  those used last first
std::vector<KeptFile> kept_in(const std::filesystem::path& folder);

/// Notes that a kept file is used now.
void mark_as_used(const std::filesystem::path& file);

/// Removes kept files, those used longest ago first, until what stays has at most `most_bytes`. Files used after
/// `since` stay in any case.
///
/// Returned  the files that are gone
std::vector<KeptFile> remove_oldest(const std::filesystem::path& folder, double most_bytes,
                                    std::filesystem::file_time_type since);

/// Whether a path is a regular file, no link, that belongs to this user or to root.
bool is_users_own(const std::filesystem::path& path);

}  // namespace coppermoon::files
