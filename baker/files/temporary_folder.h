// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "files/running_program.h"

namespace coppermoon::files {

/// Throws if there is no folder for temporary files. Call it before work begins.
///
/// Throws  Error  with the name of the folder in the environment variable TMPDIR
void require_temporary_folder();

/// Shell command that waits for the end of its standard input, and then removes the given file or folder.
Program remover_of(const std::filesystem::path& path);

/// Removes a file or folder if the program ends, or is killed, during this object's lifetime. A child process waits for
/// the program's end and then removes the file or folder. On a system without a shell, nothing is removed.
class RemovalAtEnd {
 public:
  explicit RemovalAtEnd(const std::filesystem::path& path);
  RemovalAtEnd(const RemovalAtEnd&) = delete;
  RemovalAtEnd& operator=(const RemovalAtEnd&) = delete;

 private:
  std::optional<Pipe> alive_;  ///< pipe that is closed when the program ends, or by the destructor
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

/// Gives a file a second name in a temporary folder: by a symbolic link or, if that fails, by a hard link or a copy.
///
/// Throws  std::filesystem::filesystem_error
void name_also(const std::filesystem::path& file, const std::filesystem::path& name);

}  // namespace coppermoon::files
