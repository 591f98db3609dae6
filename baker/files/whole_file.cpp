// SPDX-License-Identifier: MIT
#include "files/whole_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <fstream>
#include <optional>
#include <string>
#include <system_error>

#include "algebra/error.h"
#include "files/temporary_folder.h"

namespace coppermoon::files {
namespace {

namespace fs = std::filesystem;

algebra::Error cannot_write(const fs::path& path, int reason) {
  return algebra::Error(fmt::format("{}: cannot be written: {}", path.string(),
                                    std::generic_category().message(reason)));
}

/// New file beside the final one, removed at the program's end or by the destructor unless renamed. Where the file
/// system can, the file has no name until then.
class TemporaryFile {
 public:
  explicit TemporaryFile(const fs::path& final_path) : final_(final_path) {
    if (fs::exists("/proc/self/fd"))
      descriptor_ = ::open(final_.parent_path().c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0666);
    if (descriptor_ < 0) {
      descriptor_ = with_a_name([](const fs::path& name) {
        return ::open(name.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      });
      removal_.emplace(path_);
    }
    keep_permissions();
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!path_.empty()) ::unlink(path_.c_str());
  }

  int descriptor() const { return descriptor_; }

  void rename_to_final() {
    if (::fsync(descriptor_) != 0) throw cannot_write(final_, errno);
    if (path_.empty()) {
      if (named(final_)) return;  // at once: a program killed now leaves no other name
      with_a_name([this](const fs::path& name) { return named(name) ? 0 : -1; });
    }
    if (::rename(path_.c_str(), final_.c_str()) != 0) throw cannot_write(final_, errno);
    path_.clear();
  }

 private:
  /// Makes a file under a name that does not exist yet.
  template <typename Make>
  int with_a_name(Make make) {
    static std::atomic<unsigned> names = 0;
    for (;;) {
      path_ = final_.parent_path() / fmt::format(".coppermoon.{}-{}.tmp", ::getpid(), names++);
      const int made = make(path_);
      if (made >= 0) return made;
      path_.clear();
      if (errno != EEXIST) throw cannot_write(final_, errno);
    }
  }

  /// Copies the permissions of the replaced file, as far as this user may.
  void keep_permissions() const {
    struct stat replaced {};
    constexpr mode_t permissions = 0777;
    if (::stat(final_.c_str(), &replaced) == 0)
      ::fchmod(descriptor_, replaced.st_mode & permissions);
  }

  /// Whether the file, nameless until then, has this name now; false where another has it.
  bool named(const fs::path& name) const {
    const auto open_file = fmt::format("/proc/self/fd/{}", descriptor_);
    return ::linkat(AT_FDCWD, open_file.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
  }

  fs::path final_, path_;
  int descriptor_ = -1;
  std::optional<RemovalAtEnd> removal_;
};

/// Final path of a file: links resolved, folder made explicit.
fs::path destination(const fs::path& path) {
  std::error_code failed;
  if (path.filename().empty() || fs::is_directory(path, failed)) throw cannot_write(path, EISDIR);
  auto resolved = place_of(path, failed);
  if (failed) throw cannot_write(path, failed.value());
  if (fs::exists(resolved, failed) && !fs::is_regular_file(resolved, failed))
    throw algebra::Error(fmt::format("{}: cannot be written: not a regular file", path.string()));
  return resolved;
}

/// Flushes a folder, so that a rename survives a power cut; no error where the file system cannot.
void flush_folder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

void write_all(int descriptor, std::string_view bytes, const fs::path& path) {
  while (!bytes.empty()) {
    const auto written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) throw cannot_write(path, errno);
    if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

}  // namespace

fs::path place_of(const fs::path& path, std::error_code& failed) {
  constexpr int most_links = 40;  // as Linux has it
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

void write_whole(const fs::path& path, const std::function<void(int)>& fill) {
  const auto target = destination(path);
  TemporaryFile file(target);
  fill(file.descriptor());
  file.rename_to_final();
  flush_folder(target.parent_path());
}

void write_whole(const fs::path& path, std::string_view text) {
  write_whole(path, [&](int descriptor) { write_all(descriptor, text, path); });
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
  const auto cannot_read = [&](std::string_view why) {
    return algebra::Error(fmt::format("{}: cannot be read: {}", path.string(), why));
  };
  if (!fs::exists(path)) throw cannot_read("no such file");
  require_regular_file(path);
  std::ifstream file(path, std::ios::binary);
  if (!file) throw cannot_read(std::generic_category().message(errno));
  std::string bytes(fs::file_size(path), ' ');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  return bytes;
}

std::string beginning_of(const fs::path& path, std::size_t most_bytes) {
  require_regular_file(path);
  std::ifstream file(path, std::ios::binary);
  std::error_code failed;
  if (!file) throw algebra::Error(fmt::format("{}: cannot be read", path.string()));
  const auto size = fs::file_size(path, failed);
  std::string text(failed ? most_bytes : std::min<std::size_t>(size, most_bytes), ' ');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  return text;
}

void require_place_for(const std::filesystem::path& file) {
  std::error_code failed;
  const auto target = fs::is_symlink(file, failed) ? place_of(file, failed) : file;
  const auto folder = target.has_parent_path() ? target.parent_path() : std::filesystem::path(".");
  if (!std::filesystem::is_directory(folder, failed))
    throw algebra::Error(fmt::format("{}: no such directory", folder.string()));
  if (std::filesystem::is_directory(file, failed))
    throw algebra::Error(fmt::format("{}: is a directory", file.string()));
}

}  // namespace coppermoon::files
