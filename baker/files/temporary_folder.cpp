// SPDX-License-Identifier: MIT
#include "files/temporary_folder.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

#include "algebra/error.h"

namespace coppermoon::files {

void require_temporary_folder() {
  std::error_code failed;
  if (!std::filesystem::temp_directory_path(failed).empty() && !failed) return;
  const char* told = std::getenv("TMPDIR");
  throw algebra::Error(fmt::format("TMPDIR = {}: no such directory, allowed one that is there",
                                   told != nullptr ? told : "/tmp"));
}

RemovalAtEnd::RemovalAtEnd(const std::filesystem::path& path) {
  try {
    alive_.emplace();
    start(remover_,
          {.words = {"sh", "-c", "cat && rm -rf -- \"$0\"", std::filesystem::absolute(path)},
           .package = "dash",
           .outlives_us = true},
          {.input = alive_->out.number});
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

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace coppermoon::files
