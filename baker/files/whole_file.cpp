// SPDX-License-Identifier: MIT
#include "files/whole_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <fstream>
#include <limits>
#include <string>
#include <system_error>

#include "algebra/error.h"
#include "files/new_file.h"

namespace coppermoon::files {
namespace {

namespace fs = std::filesystem;

/// The path to which a file will be written, with all links followed.
///
/// Throws  Error  if no regular file can be there
fs::path destination(const fs::path& path) {
  require_possible_name(path);
  std::error_code failed;
  if (path.filename().empty() || fs::is_directory(path, failed))
    throw cannot_write(path, std::make_error_code(std::errc::is_a_directory));
  auto resolved = place_of(path, failed);
  if (failed) throw cannot_write(path, failed);
  if (fs::exists(resolved, failed) && !fs::is_regular_file(resolved, failed))
    throw algebra::Error(fmt::format("{}: cannot be written: not a regular file", path.string()));
  return resolved;
}

}  // namespace

algebra::Error cannot_write(const fs::path& path, std::error_code reason) {
  return algebra::Error(fmt::format("{}: cannot be written: {}", path.string(), reason.message()));
}

fs::path place_of(const fs::path& path, std::error_code& failed) {
  constexpr int most_links = 40;  // the same limit as on Linux
  auto place = fs::weakly_canonical(fs::absolute(path, failed), failed);
  std::error_code absent;
  for (int links = 0; !failed && fs::is_symlink(place, absent); ++links) {
    if (links == most_links) {
      failed = std::make_error_code(std::errc::too_many_symbolic_link_levels);
      return path;
    }
    const auto target = fs::read_symlink(place, failed);
    if (!failed) place = fs::weakly_canonical(place.parent_path() / target, failed);
  }
  return place;
}

void write_whole(const fs::path& path, const std::function<void(const Handle&)>& fill) {
  NewFile file(destination(path));
  fill(file.handle());
  file.put_in_place();
}

void write_whole(const fs::path& path, std::string_view text) {
  write_whole(path, [&](const Handle& file) {
    if (const auto reason = write_at(file, 0, text)) throw cannot_write(path, reason);
  });
}

void require_regular_file(const fs::path& path) {
  std::error_code failed;
  const auto status = fs::status(path, failed);
  if (fs::is_directory(status))
    throw algebra::Error(fmt::format("{}: cannot be read: it is a directory", path.string()));
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw algebra::Error(fmt::format("{}: cannot be read: it is no regular file", path.string()));
}

std::string bytes_of(const fs::path& path) {
  return beginning_of(path, std::numeric_limits<std::size_t>::max());
}

std::string beginning_of(const fs::path& path, std::size_t most_bytes) {
  const auto cannot_read = [&](std::string_view why) {
    return algebra::Error(fmt::format("{}: cannot be read: {}", path.string(), why));
  };
  std::error_code failed;
  if (!fs::exists(path, failed)) throw cannot_read(failed ? failed.message() : "no such file");
  require_regular_file(path);
  std::ifstream file(path, std::ios::binary);
  if (!file) throw cannot_read(std::generic_category().message(errno));
  std::string bytes(std::min<std::uintmax_t>(fs::file_size(path), most_bytes), ' ');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  return bytes;
}

std::string_view why_not_on_windows(std::string_view name) {
  using namespace std::string_view_literals;
  if (name == "." || name == "..") return {};
  if (name.ends_with('.') || name.ends_with(' ')) return "ends in a dot or a blank";
  if (std::ranges::any_of(name, [](unsigned char c) { return c < ' '; }) ||
      name.find_first_of("<>:\"|?*") != name.npos)
    return "has one of <>:\"|?*";
  std::string stem(name.substr(0, name.find('.')));
  while (stem.ends_with(' ')) stem.pop_back();
  std::ranges::transform(stem, stem.begin(), [](unsigned char c) { return std::toupper(c); });
  const bool numbered = stem.size() == 4 && stem[3] >= '1' && stem[3] <= '9' &&
                        (stem.starts_with("COM") || stem.starts_with("LPT"));
  constexpr std::array devices{"CON"sv, "PRN"sv, "AUX"sv, "NUL"sv};
  return numbered || std::ranges::find(devices, stem) != devices.end() ? "is a device" : "";
}

void require_possible_name(const fs::path& path) {
  if constexpr (fs::path::preferred_separator == '\\') {
    std::string_view why;
    if (path.has_root_name() && !path.has_root_directory()) why = "has one of <>:\"|?*";
    for (const auto& part : path.relative_path())
      if (why.empty()) why = why_not_on_windows(part.string());
    if (!why.empty())
      throw algebra::Error(
          fmt::format("{}: a name of it {}, which Windows does not allow", path.string(), why));
  }
}

void require_place_for(const std::filesystem::path& file) {
  require_possible_name(file);
  std::error_code failed;
  const auto target = fs::is_symlink(file, failed) ? place_of(file, failed) : file;
  const auto folder = target.has_parent_path() ? target.parent_path() : std::filesystem::path(".");
  if (!std::filesystem::is_directory(folder, failed))
    throw algebra::Error(fmt::format("{}: no such directory", folder.string()));
  if (std::filesystem::is_directory(file, failed))
    throw algebra::Error(fmt::format("{}: is a directory", file.string()));
}

}  // namespace coppermoon::files
