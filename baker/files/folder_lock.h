// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>

namespace coppermoon::files {

/// Exclusive lock on an output folder for this object's lifetime; other processes wait for it. A file
/// system without locks grants it to all.
class FolderLock {
 public:
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;
};

/// Folder kept to one purpose for this object's lifetime: processes of one purpose share it. Beside a
/// FolderLock neither waits for the other. A file system without locks grants it to all.
///
/// Given  purpose  a number that tells purposes apart, as a fingerprint
class FolderClaim {
 public:
  FolderClaim(const std::filesystem::path& folder, std::uint64_t purpose);
  ~FolderClaim();
  FolderClaim(const FolderClaim&) = delete;
  FolderClaim& operator=(const FolderClaim&) = delete;

  /// Whether nobody keeps the folder to another purpose. Of two that claim it in the same
  /// microseconds, neither may be alone.
  bool alone() const { return alone_; }

 private:
  int descriptor_;
  bool alone_ = true;
};

}  // namespace coppermoon::files
