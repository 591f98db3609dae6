// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>

#include "algebra/error.h"
#include "files/temporary_folder.h"

namespace coppermoon::files {

Program remover_of(const std::filesystem::path& path) {
  return {.words = {"sh", "-c", "cat && rm -rf -- \"$0\"", path}, .package = "dash"};
}

TemporaryFolder::TemporaryFolder() {
  require_temporary_folder();
  std::string name = (std::filesystem::temp_directory_path() / "coppermoon-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr)
    throw algebra::Error(
        fmt::format("{}: cannot be made: {}", name, std::generic_category().message(errno)));
  path_ = name;
  removal_.emplace(path_);
}

}  // namespace coppermoon::files
