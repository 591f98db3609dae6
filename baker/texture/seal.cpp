// SPDX-License-Identifier: MIT
#include "texture/seal.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "algebra/error.h"
#include "files/fingerprint.h"

namespace coppermoon::texture {
namespace {

using namespace std::string_view_literals;

constexpr std::size_t seal_digits = 16;

/// Private memory map of a file: writes do not reach the file.
class MappedFile {
 public:
  explicit MappedFile(int descriptor) {
    struct stat about {};
    if (::fstat(descriptor, &about) != 0 || !S_ISREG(about.st_mode) || about.st_size == 0) return;
    size_ = static_cast<std::size_t>(about.st_size);
    start_ = ::mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_PRIVATE, descriptor, 0);
  }
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;
  ~MappedFile() {
    if (start_ != MAP_FAILED) ::munmap(start_, size_);
  }

  char* start() { return static_cast<char*>(start_); }
  std::string_view bytes() const {
    return start_ == MAP_FAILED ? ""sv : std::string_view(static_cast<char*>(start_), size_);
  }

 private:
  void* start_ = MAP_FAILED;
  std::size_t size_ = 0;
};

/// Offset of the digits: behind the attribute's name, type and length, as OpenEXR writes them.
std::optional<std::size_t> place_of_digits(std::string_view bytes) {
  const auto before = std::string(seal_attribute) + std::string("\0string\0\x10\0\0\0"sv);
  const auto found = bytes.find(before);
  if (found == bytes.npos || bytes.size() - found < before.size() + seal_digits)
    return std::nullopt;
  return found + before.size();
}

std::string digits_of(std::string_view bytes) {
  return fmt::format("{:016x}", files::fingerprint(bytes));
}

}  // namespace

void seal(int descriptor, const std::filesystem::path& path) {
  const auto require = [&](bool done) {
    if (!done)
      throw algebra::Error(fmt::format("{}: cannot be written: {}", path.string(),
                                       std::generic_category().message(errno)));
  };
  const MappedFile file(descriptor);
  require(!file.bytes().empty());
  const auto place = place_of_digits(file.bytes());
  if (!place)
    throw algebra::Error(fmt::format("{}: has no attribute {}", path.string(), seal_attribute));
  require(::pwrite(descriptor, digits_of(file.bytes()).data(), seal_digits,
                   static_cast<off_t>(*place)) == static_cast<ssize_t>(seal_digits));
}

bool is_sealed(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) return false;
  MappedFile file(descriptor);
  ::close(descriptor);
  const auto place = place_of_digits(file.bytes());
  if (!place) return false;
  const std::string told(file.bytes().substr(*place, seal_digits));
  std::string_view(unsealed).copy(file.start() + *place, seal_digits);
  return digits_of(file.bytes()) == told;
}

}  // namespace coppermoon::texture
