// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "files/descriptor_posix.h"
#include "files/handle.h"

namespace coppermoon::files {
void Handle::close() {
  if (number >= 0) ::close(descriptor_of(*this));
  number = -1;
}

Handle opened(const std::filesystem::path& file) {
  return Handle(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
}

std::uint64_t size_of(const Handle& file) {
  struct stat about {};
  if (::fstat(descriptor_of(file), &about) != 0 || !S_ISREG(about.st_mode)) return 0;
  return static_cast<std::uint64_t>(about.st_size);
}

std::string bytes_at(const Handle& file, std::uint64_t place, std::size_t count) {
  std::string bytes(count, '\0');
  const auto got = ::pread(descriptor_of(file), bytes.data(), count, static_cast<off_t>(place));
  bytes.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
  return bytes;
}

std::error_code write_at(const Handle& file, std::uint64_t place, std::string_view bytes) {
  while (!bytes.empty()) {
    const auto written =
        ::pwrite(descriptor_of(file), bytes.data(), bytes.size(), static_cast<off_t>(place));
    if (written < 0 && errno != EINTR) return {errno, std::generic_category()};
    if (written <= 0) continue;
    bytes.remove_prefix(static_cast<std::size_t>(written));
    place += static_cast<std::uint64_t>(written);
  }
  return {};
}

}  // namespace coppermoon::files
