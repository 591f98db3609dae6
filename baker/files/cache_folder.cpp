// SPDX-License-Identifier: MIT
#include "files/cache_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "algebra/error.h"

namespace coppermoon::files {
namespace {

namespace fs = std::filesystem;
using About = struct stat;

bool is_own(const About& about) { return about.st_uid == ::geteuid() || about.st_uid == 0; }

/// Whether a path, and its target if it is a link, belong to this user or to the administrator.
bool is_own(const fs::path& path) {
  About itself{}, behind_it{};
  return ::lstat(path.c_str(), &itself) == 0 && ::stat(path.c_str(), &behind_it) == 0 &&
         is_own(itself) && is_own(behind_it);
}

}  // namespace

void make_private_folder(const fs::path& folder) {
  const auto path = folder.has_filename() ? folder : folder.parent_path();  // of "kept/" too
  std::error_code failed;
  if (path.has_parent_path()) fs::create_directories(path.parent_path(), failed);
  if (::mkdir(path.c_str(), 0700) != 0 && errno != EEXIST)
    failed.assign(errno, std::generic_category());
  if (!failed && !fs::is_directory(path)) failed = std::make_error_code(std::errc::not_a_directory);
  if (failed)
    throw algebra::Error(
        fmt::format("{}: no folder can be made there: {}", folder.string(), failed.message()));
  if (!is_own(path))
    throw algebra::Error(
        fmt::format("{}: belongs to another user, allowed a folder of your own", folder.string()));
}

bool is_users_own(const fs::path& path) {
  About about{};
  return ::lstat(path.c_str(), &about) == 0 && S_ISREG(about.st_mode) && is_own(about);
}

FileLock::FileLock(const fs::path& file, const std::function<void()>& waiting) {
  const auto lock = file.parent_path() / fmt::format(".{}.lock", file.filename().string());
  descriptor_ = ::open(lock.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0600);
  if (descriptor_ < 0 || !is_users_own(lock)) return;
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  waiting();
  while (::flock(descriptor_, LOCK_EX) != 0 && errno == EINTR) continue;
}

FileLock::~FileLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace coppermoon::files
