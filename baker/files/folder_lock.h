// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>

namespace coppermoon::files {

/// Exclusive lock on a folder for this object's lifetime; other processes wait. A file system without locks grants
/// every lock.
class FolderLock {
 public:
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;
};

/// Claim on a folder for one purpose, for this object's lifetime; processes of the same purpose share it. Independent
/// of FolderLock. A file system without locks grants every claim.
///
/// Given  purpose  as a fingerprint
class FolderClaim {
 public:
  FolderClaim(const std::filesystem::path& folder, std::uint64_t purpose);
  ~FolderClaim();
  FolderClaim(const FolderClaim&) = delete;
  FolderClaim& operator=(const FolderClaim&) = delete;

  /// Whether no other purpose has a claim. Of two purposes within microseconds, neither may be alone.
  bool alone() const { return alone_; }

 private:
  int descriptor_;
  bool alone_ = true;
};

}  // namespace coppermoon::files
