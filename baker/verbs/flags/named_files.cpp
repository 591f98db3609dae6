// SPDX-License-Identifier: MIT
#include "verbs/flags/named_files.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>

#include "algebra/error.h"
#include "files/whole_file.h"

namespace coppermoon::verbs {
namespace {

namespace fs = std::filesystem;

/// File or folder, and the flag that names it.
struct NamedFile {
  std::string flag;
  fs::path path;
};

std::vector<NamedFile> files_called(const char* kind, const CLI::App& verb) {
  std::vector<NamedFile> files;
  for (const auto* option : verb.get_options()) {
    if (option->get_type_name() != kind || option->get_lnames().empty()) continue;
    for (const auto& path : option->results())
      if (!path.empty()) files.push_back({"--" + option->get_lnames().front(), path});
  }
  return files;
}

/// Path with its links followed, whether or not anything is there yet.
fs::path place_of(const fs::path& path) {
  std::error_code failed;
  const auto place = fs::weakly_canonical(fs::absolute(path, failed), failed);
  return failed ? path : place;
}

bool are_one(const fs::path& a, const fs::path& b) {
  std::error_code failed;
  return fs::equivalent(a, b, failed) || place_of(a) == place_of(b);
}

bool stands_in(const fs::path& file, const fs::path& folder) {
  std::error_code failed;
  if (!fs::exists(file, failed)) return false;
  const auto path = place_of(file);
  auto above = place_of(folder);
  if (above.filename().empty()) above = above.parent_path();  // "film/" that is not there yet
  return std::mismatch(above.begin(), above.end(), path.begin(), path.end()).first == above.end();
}

}  // namespace

bool ends_as_a_file(const fs::path& name) {
  static constexpr std::array endings{".avif", ".csv",  ".exr", ".glb", ".html", ".ics",
                                      ".jpg",  ".json", ".mov", ".mp4", ".pdf",  ".png",
                                      ".pov",  ".svg",  ".tif", ".tx",  ".usda"};
  return std::ranges::find(endings, name.extension()) != endings.end();
}

bool says_where_results_go(const CLI::Option& flag) {
  return flag.get_type_name() == written_file || flag.get_type_name() == written_folder;
}

void require_files_apart(const CLI::App& verb) {
  const auto read = files_called(read_file, verb), written = files_called(written_file, verb);
  for (const auto& file : read) files::require_regular_file(file.path);
  for (auto file = written.begin(); file != written.end(); ++file) {
    for (const auto& other : read)
      if (are_one(file->path, other.path))
        throw algebra::Error(
            fmt::format("{}: {} would overwrite the file that {} reads, allowed another",
                        file->path.string(), file->flag, other.flag));
    for (auto other = written.begin(); other != file; ++other)
      if (are_one(file->path, other->path))
        throw algebra::Error(fmt::format("{}: {} and {} write one file, allowed two",
                                         file->path.string(), other->flag, file->flag));
  }
  for (const auto& folder : files_called(written_folder, verb)) {
    if (ends_as_a_file(folder.path) && !fs::exists(folder.path))
      throw algebra::Error(fmt::format("{}: {} names a folder, allowed a name without {}",
                                       folder.path.string(), folder.flag,
                                       folder.path.extension().string()));
    for (const auto& file : read)
      if (file.flag != "--recipe" && file.flag != "--add" && stands_in(file.path, folder.path))
        throw algebra::Error(
            fmt::format("{}: {} reads a file of the folder that {} writes, allowed elsewhere",
                        file.path.string(), file.flag, folder.flag));
  }
}

}  // namespace coppermoon::verbs
