// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <windows.h>

#include <atomic>

#include "algebra/error.h"
#include "files/environment.h"
#include "files/temporary_folder.h"

namespace coppermoon::files {

/// The program is cmd, which waits in `set /p` until its input ends. It takes the path from a variable, because cmd does
/// not follow the usual rules for quotes on a command line.
Program remover_of(const std::filesystem::path& path) {
  return {.words = {"cmd", "/d", "/c", "set /p ended= & rd /s /q %GONE% & del /f /q %GONE%"},
          .package = "Windows",
          .variables = {fmt::format("GONE=\"{}\"", path.string())}};
}

TemporaryFolder::TemporaryFolder() {
  require_temporary_folder();
  static std::atomic<unsigned> names = 0;
  std::error_code failed;
  do
    path_ = std::filesystem::temp_directory_path() /
            fmt::format("coppermoon-{}-{}", ::GetCurrentProcessId(), names++);
  while (std::filesystem::exists(path_, failed));
  if (const auto reason = make_folder_for_user(path_))
    throw algebra::Error(fmt::format("{}: cannot be made: {}", path_.string(), reason.message()));
  removal_.emplace(path_);
}

}  // namespace coppermoon::files
