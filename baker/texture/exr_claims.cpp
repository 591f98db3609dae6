// SPDX-License-Identifier: MIT
#include "texture/exr_claims.h"

#include <array>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string>

#include "algebra/error.h"

namespace coppermoon::texture {
namespace {

/// A file that is read in OpenEXR's words; nothing comes once it has ended.
class Reader {
 public:
  explicit Reader(const std::filesystem::path& path)
      : file_(path, std::ios::binary), size_(std::filesystem::file_size(path)) {}

  /// Of at most 255 letters; a longer one is no name, and neither is what follows it.
  std::string name() {
    std::string text;
    for (int letter = file_.get(); letter > 0 && text.size() < 256; letter = file_.get())
      text += static_cast<char>(letter);
    return text;
  }
  /// Little endian.
  std::optional<std::int64_t> integer() {
    std::array<unsigned char, 4> bytes{};
    if (!file_.read(reinterpret_cast<char*>(bytes.data()), bytes.size())) return {};
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) value |= std::uint32_t{bytes[i]} << (8 * i);
    return static_cast<std::int32_t>(value);
  }
  std::int64_t at() { return static_cast<std::int64_t>(file_.tellg()); }
  std::int64_t left() { return static_cast<std::int64_t>(size_) - at(); }
  void go_to(std::int64_t place) { file_.seekg(place); }
  bool good() const { return file_.good(); }

 private:
  std::ifstream file_;
  std::uintmax_t size_;
};

/// Whether an attribute's own counts are within its size.
bool honest(Reader& file, const std::string& type, std::int64_t size) {
  const std::int64_t end = file.at() + size;
  if (size < 0 || size > file.left()) return false;
  if (type == "preview") {
    const auto width = file.integer(), height = file.integer();
    return width && height && *width >= 0 && *height >= 0 && *width * *height == (size - 8) / 4;
  }
  while (type == "stringvector" && file.at() < end) {
    const auto length = file.integer();
    if (!length || *length < 0 || *length > end - file.at()) return false;
    file.go_to(file.at() + *length);
  }
  return true;
}

}  // namespace

void require_honest_exr(const std::filesystem::path& path) {
  constexpr std::int64_t of_several_parts = 0x1000;
  Reader file(path);
  file.integer();
  const bool several = (file.integer().value_or(0) & of_several_parts) != 0;
  bool ended = false;
  while (file.good()) {
    const auto name = file.name();
    if (name.empty() && (ended || !several)) return;
    ended = name.empty();
    if (ended) continue;
    const auto type = file.name();
    const auto size = file.integer();
    if (!size) return;
    const auto begin = file.at();
    if (!honest(file, type, *size))
      throw algebra::Error(fmt::format(
          "{}: cannot be read: attribute \"{}\" of {} bytes, allowed as many as the file holds",
          path.string(), name, *size));
    file.go_to(begin + *size);
  }
}

}  // namespace coppermoon::texture
