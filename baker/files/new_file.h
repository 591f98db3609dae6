// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "algebra/error.h"
#include "files/handle.h"
#include "files/temporary_folder.h"

namespace coppermoon::files {

/// "PATH: cannot be written: REASON".
algebra::Error cannot_write(const std::filesystem::path& path, std::error_code reason);

/// New file beside the final one, removed by the destructor or at the program's end unless it was put in place. Where
/// the file system can, the file has no name until then. It has the permissions of the file that it replaces.
class NewFile {
 public:
  /// Given   final_path  with all links followed
  /// Throws  Error       when it cannot be made
  explicit NewFile(const std::filesystem::path& final_path);
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;
  ~NewFile();

  const Handle& handle() const { return handle_; }

  /// Flushes it to the disk and gives it the final name, for good: also after a power cut.
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
