// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "files/running_program.h"

namespace coppermoon::files {

/// Refuses a system without a folder for temporary files, before any work.
///
/// Throws  Error  with the name that TMPDIR gives
void require_temporary_folder();

/// Removal of a file or a folder when the program ends during this object's lifetime, whatever ends it: a child
/// waits for the program's end. Where there is no shell, file or folder stay.
class RemovalAtEnd {
 public:
  explicit RemovalAtEnd(const std::filesystem::path& path);
  RemovalAtEnd(const RemovalAtEnd&) = delete;
  RemovalAtEnd& operator=(const RemovalAtEnd&) = delete;

 private:
  std::optional<Pipe> alive_;  ///< closed by the end of the program, or after the remover's
  RunningProgram remover_;
};

/// Temporary folder, removed with this object or at the program's end, whatever ends it.
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
