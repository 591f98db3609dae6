// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <filesystem>

namespace coppermoon::files {

/// Refuses a system without a folder for temporary files. Said before the work is done.
///
/// Throws  Error  with the name that TMPDIR gives
void require_temporary_folder();

/// A folder that is there for as long as this is, and no longer than the program, whatever ends it: a
/// shell waits beside the program for its end, by kill -9 too, and then removes the folder.
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
  int alive_ = -1;  ///< closed by the end of the program
  pid_t remover_ = 0;
};

}  // namespace coppermoon::files
