// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>

#include "files/handle.h"

namespace coppermoon::files {

/// Locks a folder for as long as the returned handle lives. Waits while another process holds the lock. On a file
/// system without locks, every lock is granted.
[[nodiscard]] Handle lock_folder(const std::filesystem::path& folder);

/// Locks a file that need not exist yet, for as long as the returned handle lives. Waits while another process of this
/// user holds the lock. The lock is an empty file in the same folder, ".NAME.lock", which only this user can open and
/// which is never removed. Another user's lock file is ignored. On a file system without locks, every lock is granted.
///
/// Given  waiting  called before lock_file starts to wait
[[nodiscard]] Handle lock_file(const std::filesystem::path& file,
                               const std::function<void()>& waiting);

/// A process's claim to use a folder for one purpose. Several processes can claim a folder for the same purpose. If two
/// claim it for different purposes at the same moment, `alone` may be false for both.
struct FolderClaim {
  Handle handle;  ///< the claim lasts as long as this handle
  bool alone =
      true;  ///< whether no other process has claimed the folder for a different purpose so far
};

/// Claims a folder for a purpose, independently of lock_folder. On a file system without locks, every claim is granted.
///
/// Given  purpose  a number that stands for the purpose, such as a fingerprint
[[nodiscard]] FolderClaim claim_folder(const std::filesystem::path& folder, std::uint64_t purpose);

}  // namespace coppermoon::files
