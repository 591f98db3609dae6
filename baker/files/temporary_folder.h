// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "files/child_process.h"

namespace coppermoon::files {

/// Refuses a system without a folder for temporary files, before any work.
///
/// Throws  Error  with the name that TMPDIR gives
void require_temporary_folder();

/// Removal of a file or a folder when the program ends while this lives, by kill -9 too: a shell waits beside
/// the program for its end. Without a shell it stays.
class RemovalAtEnd {
 public:
  explicit RemovalAtEnd(const std::filesystem::path& path);
  RemovalAtEnd(const RemovalAtEnd&) = delete;
  RemovalAtEnd& operator=(const RemovalAtEnd&) = delete;

 private:
  std::optional<Pipe> alive_;  ///< closed by the end of the program, or after the remover's
  Child remover_;
};

/// Folder that is there for as long as this is, and no longer than the program, whatever ends it.
///
/// Throws  Error  when the system's temporary folder takes none
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  std::optional<RemovalAtEnd> removal_;
};

}  // namespace coppermoon::files
