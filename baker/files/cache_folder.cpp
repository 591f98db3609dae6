// SPDX-License-Identifier: MIT
#include "files/cache_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "algebra/error.h"
#include "files/environment.h"

namespace coppermoon::files {
namespace {

namespace fs = std::filesystem;

bool names_a_kept_file(const fs::path& path) {
  const auto stem = path.stem().string();
  const auto is_digit = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
  return path.extension() == ".tx" && stem.size() == 16 && std::ranges::all_of(stem, is_digit);
}

}  // namespace

fs::path usual_cache() {
  if (const auto own = variable("COPPERMOON_CACHE"); !own.empty()) return fs::absolute(own);
  if (const auto caches = users_caches(); !caches.empty()) return caches / "coppermoon";
  throw algebra::Error("no folder for textures: the variable COPPERMOON_CACHE may name one");
}

bool is_usual_cache(const fs::path& folder) {
  try {
    std::error_code failed;
    return folder == usual_cache() || fs::equivalent(folder, usual_cache(), failed);
  } catch (const algebra::Error&) {
    return false;
  }
}

std::vector<KeptFile> kept_in(const fs::path& folder) {
  std::vector<KeptFile> all;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(folder, failed)) {
    if (!names_a_kept_file(entry.path()) || !is_users_own(entry.path())) continue;
    std::error_code gone;  // set if another process removed the file
    const KeptFile file{entry.path(), entry.file_size(gone), entry.last_write_time(gone)};
    if (!gone) all.push_back(file);
  }
  std::ranges::sort(all, std::ranges::greater{}, &KeptFile::used);
  return all;
}

void mark_as_used(const fs::path& file) {
  std::error_code ignored;
  fs::last_write_time(file, fs::file_time_type::clock::now(), ignored);
}

std::vector<KeptFile> remove_oldest(const fs::path& folder, double most_bytes,
                                    fs::file_time_type since) {
  std::vector<KeptFile> gone;
  double bytes = 0;
  for (const auto& file : kept_in(folder)) {
    bytes += static_cast<double>(file.bytes);
    std::error_code failed;
    if (bytes <= most_bytes || file.used > since || !fs::remove(file.path, failed)) continue;
    bytes -= static_cast<double>(file.bytes);
    gone.push_back(file);
  }
  return gone;
}

void make_private_folder(const fs::path& folder) {
  const auto path = folder.has_filename() ? folder : folder.parent_path();  // without a final slash
  std::error_code failed;
  if (path.has_parent_path()) fs::create_directories(path.parent_path(), failed);
  if (const auto reason = make_folder_for_user(path)) failed = reason;
  if (!failed && !fs::is_directory(path)) failed = std::make_error_code(std::errc::not_a_directory);
  if (failed)
    throw algebra::Error(fmt::format(
        "{}: no folder can be made there: {}{}", folder.string(), failed.message(),
        is_usual_cache(folder) ? "; the variable COPPERMOON_CACHE may name another" : ""));
  if (!belongs_to_user(path))
    throw algebra::Error(
        fmt::format("{}: belongs to another user, allowed a folder of your own", folder.string()));
}

bool is_users_own(const fs::path& path) {
  std::error_code failed;
  return fs::is_regular_file(fs::symlink_status(path, failed)) && belongs_to_user(path);
}

}  // namespace coppermoon::files
