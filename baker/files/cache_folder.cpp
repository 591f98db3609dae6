// SPDX-License-Identifier: MIT
#include "files/cache_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <pwd.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <string>
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

fs::path variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

bool names_a_kept_file(const fs::path& path) {
  const auto stem = path.stem().string();
  const auto is_digit = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
  return path.extension() == ".tx" && stem.size() == 16 && std::ranges::all_of(stem, is_digit);
}

}  // namespace

fs::path usual_cache() {
  if (const auto own = variable("COPPERMOON_CACHE"); !own.empty()) return fs::absolute(own);
  if (const auto xdg = variable("XDG_CACHE_HOME"); xdg.is_absolute()) return xdg / "coppermoon";
  auto home = variable("HOME");
  if (home.empty())
    if (const auto* user = ::getpwuid(::geteuid())) home = user->pw_dir;
  if (home.is_absolute()) return home / ".cache" / "coppermoon";
  throw algebra::Error("no folder for textures: the variable COPPERMOON_CACHE may name one");
}

bool is_usual_cache(const fs::path& folder) {
  try {
    std::error_code failed;
    return folder == usual_cache() || fs::equivalent(folder, usual_cache(), failed);
  } catch (const algebra::Error&) {
    return false;
  }
}

std::vector<KeptFile> kept_in(const fs::path& folder) {
  std::vector<KeptFile> all;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(folder, failed)) {
    if (!names_a_kept_file(entry.path()) || !is_users_own(entry.path())) continue;
    std::error_code gone;  // by another process
    const KeptFile file{entry.path(), entry.file_size(gone), entry.last_write_time(gone)};
    if (!gone) all.push_back(file);
  }
  std::ranges::sort(all, std::ranges::greater{}, &KeptFile::used);
  return all;
}

void mark_as_used(const fs::path& file) {
  std::error_code ignored;
  fs::last_write_time(file, fs::file_time_type::clock::now(), ignored);
}

std::vector<KeptFile> remove_oldest(const fs::path& folder, double most_bytes,
                                    fs::file_time_type since) {
  std::vector<KeptFile> gone;
  double bytes = 0;
  for (const auto& file : kept_in(folder)) {
    bytes += static_cast<double>(file.bytes);
    std::error_code failed;
    if (bytes <= most_bytes || file.used > since || !fs::remove(file.path, failed)) continue;
    bytes -= static_cast<double>(file.bytes);
    gone.push_back(file);
  }
  return gone;
}

void make_private_folder(const fs::path& folder) {
  const auto path = folder.has_filename() ? folder : folder.parent_path();  // of "kept/" too
  std::error_code failed;
  if (path.has_parent_path()) fs::create_directories(path.parent_path(), failed);
  if (::mkdir(path.c_str(), 0700) != 0 && errno != EEXIST)
    failed.assign(errno, std::generic_category());
  if (!failed && !fs::is_directory(path)) failed = std::make_error_code(std::errc::not_a_directory);
  if (failed)
    throw algebra::Error(fmt::format(
        "{}: no folder can be made there: {}{}", folder.string(), failed.message(),
        is_usual_cache(folder) ? "; the variable COPPERMOON_CACHE may name another" : ""));
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
