// SPDX-License-Identifier: MIT
#include "verbs/flags/named_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "algebra/error.h"
#include "files/whole_file.h"
#include "verbs/reports/one_line.h"

namespace coppermoon::verbs {
namespace {

namespace fs = std::filesystem;
using request::Kind;

/// A file or folder that the command line names, and the flag that names it.
struct NamedFile {
  std::string flag;
  fs::path path;
};

std::vector<NamedFile> files_of(const Verb& verb, Kind kind) {
  std::vector<NamedFile> files;
  for (const auto& parameter : verb.parameters)
    if (parameter.kind == kind && parameter.given)
      for (const auto& path : *parameter.given)
        if (!path.empty()) files.push_back({"--" + parameter.name, path});
  return files;
}

/// A path with its links resolved; if that fails, the path unchanged.
fs::path place_of(const fs::path& path) {
  std::error_code failed;
  const auto place = files::place_of(path, failed);
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
  if (above.filename().empty()) above = above.parent_path();  // removes a slash at the end
  return std::mismatch(above.begin(), above.end(), path.begin(), path.end()).first == above.end();
}

}  // namespace

bool ends_as_a_file(const fs::path& name) {
  static constexpr std::array endings{".avif", ".csv",  ".exr", ".glb", ".html", ".ics",
                                      ".jpg",  ".json", ".mov", ".mp4", ".pdf",  ".png",
                                      ".pov",  ".svg",  ".tif", ".tx",  ".usda", ".usdz"};
  return std::ranges::find(endings, name.extension()) != endings.end();
}

std::optional<colour::WorkingSpace> space_for(const fs::path& file,
                                              std::optional<colour::WorkingSpace> asked) {
  const auto named = colour::space_in_name(file.stem().string());
  if (named && asked && *asked != *named)
    throw algebra::Error(fmt::format("{}: space = {}, allowed {} as its name says, or no --space",
                                     file.string(), colour::name(*asked), colour::name(*named)));
  return named ? named : asked;
}

void say_space_of(const fs::path& file, colour::WorkingSpace space, std::string_view way_out) {
  const auto stem = file.stem().string();
  if (colour::space_in_name(stem).value_or(space) == space && !colour::names_another_space(stem))
    return;
  fmt::print(stderr, "coppermoon: {}: is {}, which its name does not say{}\n",
             one_line(file.string()), colour::name(space), way_out);
}

void require_files_apart(const Verb& verb) {
  const auto read = files_of(verb, Kind::file_read), written = files_of(verb, Kind::file_written);
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
  for (const auto& folder : files_of(verb, Kind::folder_written)) {
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
