// SPDX-License-Identifier: MIT
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>

#include "files/environment.h"

namespace coppermoon::files {

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

void set_missing_variable(const char* name, const std::string& value) {
  ::setenv(name, value.c_str(), 0);
}

std::filesystem::path users_caches() {
  if (std::filesystem::path xdg = variable("XDG_CACHE_HOME"); xdg.is_absolute()) return xdg;
  std::filesystem::path home = variable("HOME");
  if (home.empty())
    if (const auto* user = ::getpwuid(::geteuid())) home = user->pw_dir;
  return home.is_absolute() ? home / ".cache" : "";
}

bool belongs_to_user(const std::filesystem::path& path) {
  struct stat itself {
  }, target{};
  const auto is_own = [](const auto& about) {
    return about.st_uid == ::geteuid() || about.st_uid == 0;
  };
  return ::lstat(path.c_str(), &itself) == 0 && ::stat(path.c_str(), &target) == 0 &&
         is_own(itself) && is_own(target);
}

std::error_code make_folder_for_user(const std::filesystem::path& folder) {
  if (::mkdir(folder.c_str(), 0700) == 0 || errno == EEXIST) return {};
  return {errno, std::generic_category()};
}

}  // namespace coppermoon::files
