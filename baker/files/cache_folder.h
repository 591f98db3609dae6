// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>

namespace coppermoon::files {

/// Makes a folder that its user alone may enter, unless it is there already.
///
/// Throws  Error  when it cannot be made, or belongs to another user
void make_private_folder(const std::filesystem::path& folder);

/// Whether a path is a regular file, no link, that belongs to this user or to root.
bool is_users_own(const std::filesystem::path& path);

/// Exclusive lock on a file that is yet to be made, for this object's lifetime; other processes of the user wait. It
/// is an empty file beside the other, ".NAME.lock", that this user alone can open, and that stays. A file system
/// without locks grants every lock; another user's lock file is ignored.
class FileLock {
 public:
  /// Given  waiting  called before a wait
  FileLock(const std::filesystem::path& file, const std::function<void()>& waiting);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  int descriptor_;
};

}  // namespace coppermoon::files
