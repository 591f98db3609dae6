// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>

#include "files/descriptor_posix.h"
#include "files/linux_or_macos.h"
#include "files/new_file.h"

namespace coppermoon::files {
namespace {

namespace fs = std::filesystem;

std::error_code last_error() { return {errno, std::generic_category()}; }

/// Gives a new file the permissions of the file that it will replace, as far as this user is allowed to.
void keep_permissions(int descriptor, const fs::path& of) {
  struct stat replaced {};
  constexpr mode_t permissions = 0777;
  if (::stat(of.c_str(), &replaced) == 0) ::fchmod(descriptor, replaced.st_mode & permissions);
}

/// Gives a nameless file a name; false if that fails, for instance because the name is taken.
bool named(const Handle& file, const fs::path& name) {
  return ::linkat(AT_FDCWD, name_of(file).c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
}

}  // namespace

/// Calls `make` with temporary names until one is not taken yet.
template <typename Make>
void NewFile::with_a_name(Make make) {
  static std::atomic<unsigned> names = 0;
  do {
    path_ = final_.parent_path() / fmt::format(".coppermoon.{}-{}.tmp", ::getpid(), names++);
    if (make(path_)) return;
    path_.clear();
  } while (errno == EEXIST);
  throw cannot_write(final_, last_error());
}

NewFile::NewFile(const fs::path& final_path)
    : final_(final_path), handle_(nameless_file(final_.parent_path())) {
  if (!handle_) {
    with_a_name([this](const fs::path& name) {
      handle_ = Handle(::open(name.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
      return static_cast<bool>(handle_);
    });
    removal_.emplace(path_);
  }
  keep_permissions(descriptor_of(handle_), final_);
}

NewFile::~NewFile() {
  if (!path_.empty()) ::unlink(path_.c_str());
}

void NewFile::put_in_place() {
  if (::fsync(descriptor_of(handle_)) != 0) throw cannot_write(final_, last_error());
  // if the final name is free, take it directly, so that no temporary name is left if the program is killed
  if (!path_.empty() || !named(handle_, final_)) {
    if (path_.empty()) with_a_name([this](const fs::path& name) { return named(handle_, name); });
    if (::rename(path_.c_str(), final_.c_str()) != 0) throw cannot_write(final_, last_error());
    path_.clear();
  }
  if (const auto folder = opened(final_.parent_path()))
    ::fsync(descriptor_of(folder));  // no error if the file system does not support it
}

}  // namespace coppermoon::files
