// SPDX-License-Identifier: MIT
#pragma once

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

}  // namespace coppermoon::files
