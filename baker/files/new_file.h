// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "algebra/error.h"
#include "files/handle.h"
#include "files/temporary_folder.h"

namespace coppermoon::files {

/// Error with the message "PATH: cannot be written: REASON".
algebra::Error cannot_write(const std::filesystem::path& path, std::error_code reason);

/// New file in the folder of the final one, removed by the destructor or at the program's end unless it was put in
/// place. Until then it has no name, if the file system allows that. It has the permissions of the file it replaces.
class NewFile {
 public:
  /// Given   final_path  with all links followed
  /// Throws  Error       if the file cannot be made
  explicit NewFile(const std::filesystem::path& final_path);
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;
  ~NewFile();

  const Handle& handle() const { return handle_; }

  /// Flushes the file to the disk and gives it its final name, so that it survives even a power cut.
  ///
  /// Throws  Error  when the system refuses
  void put_in_place();

 private:
  template <typename Make>
  void with_a_name(Make make);

  std::filesystem::path final_, path_;
  Handle handle_;
  std::optional<RemovalAtEnd> removal_;
};

}  // namespace coppermoon::files
