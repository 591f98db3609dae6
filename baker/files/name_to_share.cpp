// SPDX-License-Identifier: MIT
#include "files/name_to_share.h"

namespace coppermoon::files {

namespace fs = std::filesystem;

std::string name_to_share(const fs::path& path) {
  if (path.is_relative()) return path.generic_string();
  const auto plain = path.lexically_normal();
  std::error_code failed;
  const auto relative = plain.lexically_relative(fs::current_path(failed));
  if (!failed && !relative.empty() && *relative.begin() != "..") return relative.generic_string();
  return plain.string().starts_with("/usr/") ? plain.string() : plain.filename().string();
}

std::string shared_file(const std::string& name, const fs::path& named_in) {
  std::error_code failed;
  if (fs::path(name).is_absolute() || fs::exists(name, failed)) return name;
  const auto beside = named_in.parent_path() / name;
  return fs::exists(beside, failed) ? beside.string() : name;
}

}  // namespace coppermoon::files
