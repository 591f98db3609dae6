// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>

#include "files/handle.h"

namespace coppermoon::files {

/// Exclusive lock on a folder for the handle's lifetime; other processes wait. On a file system without locks, every
/// lock is granted.
[[nodiscard]] Handle lock_folder(const std::filesystem::path& folder);

/// Exclusive lock on a file that does not exist yet, for the handle's lifetime; the user's other processes wait. The
/// lock is an empty file beside it, ".NAME.lock", which only this user can open and which is not removed. On a file
/// system without locks, every lock is granted. Another user's lock file is ignored.
///
/// Given  waiting  called before the call has to wait
[[nodiscard]] Handle lock_file(const std::filesystem::path& file,
                               const std::function<void()>& waiting);

/// Claim on a folder for one purpose; processes with the same purpose share it.
struct FolderClaim {
  Handle handle;  ///< holds the claim for its lifetime
  bool alone =
      true;  ///< no claim for another purpose; two claims within microseconds may both get false
};

/// Claims a folder, independently of lock_folder. On a file system without locks, every claim is granted.
///
/// Given  purpose  number that stands for the purpose, such as a fingerprint
[[nodiscard]] FolderClaim claim_folder(const std::filesystem::path& folder, std::uint64_t purpose);

}  // namespace coppermoon::files
