// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <windows.h>

#include <atomic>

#include "files/handle_windows.h"
#include "files/new_file.h"

namespace coppermoon::files {
namespace {

namespace fs = std::filesystem;

/// Renames a file, replacing an earlier one. Virus scanners and previews briefly open new files without sharing them,
/// so this function keeps trying for two seconds.
bool renamed(const fs::path& from, const fs::path& to) {
  for (int tries = 0;; ++tries) {
    if (::MoveFileExW(from.c_str(), to.c_str(), MOVEFILE_REPLACE_EXISTING)) return true;
    const auto why = ::GetLastError();
    if (tries == 40 || (why != ERROR_ACCESS_DENIED && why != ERROR_SHARING_VIOLATION)) {
      ::SetLastError(why);
      return false;
    }
    ::Sleep(50);
  }
}

}  // namespace

/// Calls `make` with temporary names until one is not taken yet. If this process is killed, a helper removes the file.
/// The helper starts before the file is made and must not remove an older file, so no taken name is used.
template <typename Make>
void NewFile::with_a_name(Make make) {
  static std::atomic<unsigned> names = 0;
  std::error_code failed;
  do {
    path_ = final_.parent_path() /
            fmt::format(".coppermoon.{}-{}.tmp", ::GetCurrentProcessId(), names++);
    if (fs::exists(path_, failed)) continue;
    removal_.emplace(path_);
    if (make(path_)) return;
    const auto why = last_error();
    path_.clear();
    throw cannot_write(final_, why);
  } while (true);
}

/// The file is shared, so that libraries and other programs can open it by name and write to it. It gets the
/// permissions that its folder gives to new files.
NewFile::NewFile(const fs::path& final_path) : final_(final_path) {
  with_a_name([this](const fs::path& name) {
    handle_ = owned(::CreateFileW(name.c_str(), GENERIC_READ | GENERIC_WRITE,
                                  FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, nullptr,
                                  CREATE_NEW, FILE_ATTRIBUTE_NORMAL, nullptr));
    return static_cast<bool>(handle_);
  });
}

NewFile::~NewFile() {
  handle_.close();
  if (!path_.empty()) ::DeleteFileW(path_.c_str());
}

void NewFile::put_in_place() {
  if (!::FlushFileBuffers(system_handle(handle_))) throw cannot_write(final_, last_error());
  handle_.close();
  if (!renamed(path_, final_)) throw cannot_write(final_, last_error());
  path_.clear();
}

}  // namespace coppermoon::files
