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

/// A new file that gets its final name only when put_in_place is called. If it is not called, the file is removed by
/// the destructor or when the program ends. Until then the file has no name, if the file system allows that, or a
/// temporary name in the final folder. Its permissions are those of the file that it replaces.
class NewFile {
 public:
  /// Given   final_path  path in which all links have been resolved
  /// Throws  Error       if the file cannot be made
  explicit NewFile(const std::filesystem::path& final_path);
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;
  ~NewFile();

  const Handle& handle() const { return handle_; }

  /// Writes the file to the disk, so that it survives even a power cut, and gives it its final name.
  ///
  /// Throws  Error  if the system reports a failure
  void put_in_place();

 private:
  template <typename Make>
  void with_a_name(Make make);

  std::filesystem::path final_, path_;
  Handle handle_;
  std::optional<RemovalAtEnd> removal_;
};

}  // namespace coppermoon::files
