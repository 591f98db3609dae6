// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "files/running_program.h"

namespace coppermoon::files {

/// Refuses to start work if the system has no folder for temporary files.
///
/// Throws  Error  with the folder's name as TMPDIR gives it
void require_temporary_folder();

/// Removes a file or folder if the program ends during this object's lifetime, for whatever reason: a child process
/// waits for the program's end. On a system without a shell, the file or folder stays.
class RemovalAtEnd {
 public:
  explicit RemovalAtEnd(const std::filesystem::path& path);
  RemovalAtEnd(const RemovalAtEnd&) = delete;
  RemovalAtEnd& operator=(const RemovalAtEnd&) = delete;

 private:
  std::optional<Pipe> alive_;  ///< closed when the program ends, or after the remover has ended
  RunningProgram remover_;
};

/// Temporary folder, removed when this object is destroyed or the program ends, for whatever reason.
///
/// Throws  Error  when the system's temporary folder is not writable
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
