// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>

#include "files/handle.h"

namespace coppermoon::files {

/// Exclusive lock on a folder for the handle's lifetime; other processes wait. A file system without locks grants every
/// lock.
[[nodiscard]] Handle lock_folder(const std::filesystem::path& folder);

/// Exclusive lock on a file that is yet to be made, for the handle's lifetime; other processes of the user wait. It
/// is an empty file beside the other, ".NAME.lock", that this user alone can open, and that stays. A file system
/// without locks grants every lock; another user's lock file is ignored.
///
/// Given  waiting  called before a wait
[[nodiscard]] Handle lock_file(const std::filesystem::path& file,
                               const std::function<void()>& waiting);

/// Claim on a folder for one purpose; processes of the same purpose share it.
struct FolderClaim {
  Handle handle;  ///< holds the claim for its lifetime
  bool alone =
      true;  ///< no other purpose has a claim; of two within microseconds, neither may be alone
};

/// Claims a folder, independently of lock_folder. A file system without locks grants every claim.
///
/// Given  purpose  as a fingerprint
[[nodiscard]] FolderClaim claim_folder(const std::filesystem::path& folder, std::uint64_t purpose);

}  // namespace coppermoon::files
