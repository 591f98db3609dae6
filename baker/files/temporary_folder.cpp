// SPDX-License-Identifier: MIT
#include "files/temporary_folder.h"

#include <fmt/format.h>

#include <random>
#include <system_error>

#include "algebra/error.h"
#include "files/environment.h"

namespace coppermoon::files {

void require_temporary_folder() {
  std::error_code failed;
  if (!std::filesystem::temp_directory_path(failed).empty() && !failed) return;
  const auto told = variable("TMPDIR");
  throw algebra::Error(fmt::format("TMPDIR = {}: no such directory, allowed one that is there",
                                   told.empty() ? "/tmp" : told));
}

RemovalAtEnd::RemovalAtEnd(const std::filesystem::path& path) {
  try {
    alive_.emplace();
    auto remover = remover_of(std::filesystem::absolute(path));
    remover.outlives_us = true;
    start(remover_, remover, {.input = &alive_->out});
    alive_->out.close();
  } catch (const algebra::Error&) {
  }
}

TemporaryFolder::TemporaryFolder() {
  require_temporary_folder();
  std::random_device random;
  path_ = std::filesystem::temp_directory_path() /
          fmt::format("coppermoon-{:08x}{:08x}", random(), random());
  removal_.emplace(path_);  // first, so that a program killed in between leaves no folder
  auto reason = make_folder_for_user(path_);
  if (!reason && !belongs_to_user(path_)) reason = std::make_error_code(std::errc::file_exists);
  if (reason)
    throw algebra::Error(fmt::format("{}: cannot be made: {}", path_.string(), reason.message()));
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

void name_also(const std::filesystem::path& file, const std::filesystem::path& name) {
  std::error_code failed;
  std::filesystem::create_symlink(std::filesystem::absolute(file), name, failed);
  if (failed) std::filesystem::create_hard_link(file, name, failed);
  if (failed) std::filesystem::copy_file(file, name);
}

}  // namespace coppermoon::files
