// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <windows.h>

#include <atomic>

#include "algebra/error.h"
#include "files/environment.h"
#include "files/temporary_folder.h"

namespace coppermoon::files {

/// A child process, cmd, waits in `set /p` until its input ends. It takes the path from a variable, because cmd does
/// not follow the usual rules for quotes on a command line.
RemovalAtEnd::RemovalAtEnd(const std::filesystem::path& path) {
  try {
    alive_.emplace();
    start(remover_,
          {.words = {"cmd", "/d", "/c", "set /p ended= & rd /s /q %GONE% & del /f /q %GONE%"},
           .package = "Windows",
           .variables = {fmt::format("GONE=\"{}\"", std::filesystem::absolute(path).string())},
           .outlives_us = true},
          {.input = &alive_->out});
    alive_->out.close();
  } catch (const algebra::Error&) {
  }
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
