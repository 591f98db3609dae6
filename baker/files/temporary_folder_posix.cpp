// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>

#include "algebra/error.h"
#include "files/temporary_folder.h"

namespace coppermoon::files {

RemovalAtEnd::RemovalAtEnd(const std::filesystem::path& path) {
  try {
    alive_.emplace();
    start(remover_,
          {.words = {"sh", "-c", "cat && rm -rf -- \"$0\"", std::filesystem::absolute(path)},
           .package = "dash",
           .outlives_us = true},
          {.input = &alive_->out});
    alive_->out.close();
  } catch (const algebra::Error&) {
  }
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
