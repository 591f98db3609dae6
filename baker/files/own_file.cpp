// SPDX-License-Identifier: MIT
#include "files/own_file.h"

#include <fmt/format.h>

#include "algebra/error.h"
#include "files/fingerprint.h"
#include "files/whole_file.h"

namespace coppermoon::files {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view mark = " as coppermoon wrote it: ";

/// Whether something exists at a path, even a dangling link.
bool is_taken(const fs::path& path) {
  std::error_code failed;
  return fs::exists(fs::symlink_status(path, failed));
}

}  // namespace

std::string stamped(std::string_view text, std::string_view comment, std::string_view end) {
  return fmt::format("{}{}{}{:016x}{}\n", text, comment, mark, fingerprint(text), end);
}

bool is_stamped(const fs::path& file) {
  std::error_code failed;
  if (!fs::is_regular_file(fs::symlink_status(file, failed))) return false;
  const auto bytes = bytes_of(file);
  const auto at = bytes.rfind(mark);
  if (at == std::string::npos) return false;
  const auto text = bytes.substr(0, bytes.rfind('\n', at) + 1);
  const std::string_view end = bytes.ends_with(" -->\n") ? " -->" : "";
  return bytes == stamped(text, bytes.substr(text.size(), at - text.size()), end);
}

void require_no_link(const fs::path& path) {
  std::error_code failed;
  if (fs::is_symlink(path, failed))
    throw algebra::Error(fmt::format(
        "{}: is a link, which is followed only where you name it; allowed none", path.string()));
}

std::string not_as_written(const fs::path& file) {
  return fmt::format(
      "{}: is not as coppermoon wrote it, and would be overwritten; move it, or choose another "
      "folder",
      file.string());
}

void require_stamped(const fs::path& file) {
  require_no_link(file);
  if (is_taken(file) && !is_stamped(file)) throw algebra::Error(not_as_written(file));
}

}  // namespace coppermoon::files
