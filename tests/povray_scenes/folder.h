// SPDX-License-Identifier: MIT
#pragma once

#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace coppermoon::povray_scenes {

/// A new empty folder, gone with all it holds at the end.
struct TemporaryFolder {
  std::filesystem::path path;

  TemporaryFolder() {
    auto name = (std::filesystem::temp_directory_path() / "coppermoon_XXXXXX").string();
    if (!::mkdtemp(name.data())) throw std::runtime_error(name + ": cannot be made");
    path = name;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
};

/// A program of the shell's in a folder: its path.
inline std::string script_in(const std::filesystem::path& folder, const std::string& script) {
  const auto file = folder / "stand-in";
  std::ofstream(file) << "#!/bin/sh\n" << script << "\n";
  std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  return file.string();
}

inline long files_in(const std::filesystem::path& folder) {
  return std::distance(std::filesystem::directory_iterator(folder), {});
}

}  // namespace coppermoon::povray_scenes
