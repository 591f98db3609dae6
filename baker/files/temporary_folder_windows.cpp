// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "files/temporary_folder.h"

namespace coppermoon::files {

/// The program is cmd, which waits in `set /p` until its input ends. It takes the path from a variable, because cmd does
/// not follow the usual rules for quotes on a command line.
Program remover_of(const std::filesystem::path& path) {
  return {.words = {"cmd", "/d", "/c", "set /p ended= & rd /s /q %GONE% & del /f /q %GONE%"},
          .package = "Windows",
          .variables = {fmt::format("GONE=\"{}\"", path.string())}};
}

}  // namespace coppermoon::files
