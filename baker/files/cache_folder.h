// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>

namespace coppermoon::files {

/// Makes a folder that its user alone may look into, unless it is there already.
///
/// Throws  Error  when it cannot be made, or belongs to another user
void make_private_folder(const std::filesystem::path& folder);

/// Whether a regular file, no link, is there that this user made, or the administrator.
bool is_users_own(const std::filesystem::path& path);

/// Exclusive lock on a file that is yet to be made, for this object's lifetime: an empty file beside it,
/// ".NAME.lock", that this user alone can open, and that stays there. Other processes of the user wait. A
/// file system without locks grants it to all; a lock file of another user's is passed over.
class FileLock {
 public:
  /// Given  waiting  called before it waits
  FileLock(const std::filesystem::path& file, const std::function<void()>& waiting);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  int descriptor_;
};

}  // namespace coppermoon::files
