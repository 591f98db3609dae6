// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "files/running_program.h"

namespace coppermoon::files {

/// Refuses to start work if there is no folder for temporary files.
///
/// Throws  Error  with the folder that the variable TMPDIR names
void require_temporary_folder();

/// Removes a file or folder if the program ends, or is killed, during this object's lifetime. A child process waits for
/// that and removes it. On a system without a shell, the file or folder stays.
class RemovalAtEnd {
 public:
  explicit RemovalAtEnd(const std::filesystem::path& path);
  RemovalAtEnd(const RemovalAtEnd&) = delete;
  RemovalAtEnd& operator=(const RemovalAtEnd&) = delete;

 private:
  std::optional<Pipe> alive_;  ///< closed when the program ends, or by the destructor
  RunningProgram remover_;
};

/// A temporary folder, removed when this object is destroyed or when the program ends or is killed.
///
/// Throws  Error  if the system's temporary folder is not writable
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

/// Gives a file another name, in a temporary folder: by a link, or where links are not allowed, by a hard link or a copy.
///
/// Throws  std::filesystem::filesystem_error
void name_also(const std::filesystem::path& file, const std::filesystem::path& name);

}  // namespace coppermoon::files
