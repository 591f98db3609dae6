// SPDX-License-Identifier: MIT
#include "texture/openimageio/image_claims.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "texture/openimageio/image_input.h"

namespace coppermoon::texture {
namespace {

/// Reads a file word by word; past its end, nothing.
class Reader {
 public:
  explicit Reader(const std::filesystem::path& path)
      : file_(path, std::ios::binary), size_(std::filesystem::file_size(path)) {}

  /// A name of at most 255 letters; a longer text is no name, and neither is what follows it.
  std::string name() {
    std::string text;
    for (int letter = file_.get(); letter > 0 && text.size() < 256; letter = file_.get())
      text += static_cast<char>(letter);
    return text;
  }
  /// Four bytes as they are.
  std::string bytes() {
    std::string text(4, '\0');
    if (!file_.read(text.data(), 4)) text.clear();
    return text;
  }
  /// Little endian, as OpenEXR has it.
  std::optional<std::int64_t> integer() {
    const auto text = bytes();
    if (text.empty()) return {};
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>(text[i]);
    return static_cast<std::int32_t>(value);
  }
  /// Big endian, as PNG has it.
  std::optional<std::int64_t> length() {
    const auto text = bytes();
    if (text.empty()) return {};
    std::uint32_t value = 0;
    for (const char byte : text) value = value << 8 | static_cast<unsigned char>(byte);
    return value;
  }
  std::int64_t at() { return static_cast<std::int64_t>(file_.tellg()); }
  std::int64_t left() { return static_cast<std::int64_t>(size_) - at(); }
  void go_to(std::int64_t place) { file_.seekg(place); }
  bool good() const { return file_.good(); }

 private:
  std::ifstream file_;
  std::uintmax_t size_;
};

/// Bytes of the types that always have as many: OpenEXR reads so many, whatever the size says.
std::optional<std::int64_t> bytes_of(std::string_view type) {
  using Type = std::pair<std::string_view, std::int64_t>;
  constexpr std::array<Type, 24> all{
      {{"box2f", 16},         {"box2i", 16},   {"chromaticities", 32},
       {"compression", 1},    {"double", 8},   {"envmap", 1},
       {"float", 4},          {"int", 4},      {"keycode", 28},
       {"lineOrder", 1},      {"m33d", 72},    {"m33f", 36},
       {"m44d", 128},         {"m44f", 64},    {"rational", 8},
       {"deepImageState", 1}, {"tiledesc", 9}, {"timecode", 8},
       {"v2d", 16},           {"v2f", 8},      {"v2i", 8},
       {"v3d", 24},           {"v3f", 12},     {"v3i", 12}}};
  for (const auto& [name, bytes] : all)
    if (name == type) return bytes;
  return {};
}

/// Goes over texts, each after its length.
void pass_texts(Reader& file, std::int64_t end) {
  while (file.good() && file.at() < end) {
    const auto length = file.integer().value_or(-1);
    if (length < 0 || length > end - file.at()) return;
    file.go_to(file.at() + length);
  }
}

/// Goes over channels, each a name, a pixel type and 12 bytes, and the empty name behind them.
/// OpenImageIO 2.4.7 ends the program at a pixel type that OpenEXR does not have.
void pass_channels(Reader& file, const std::filesystem::path& path) {
  constexpr std::int64_t whole_number = 0, half = 1, floating = 2;
  for (auto name = file.name(); file.good() && !name.empty(); name = file.name()) {
    const auto type = file.integer();
    if (!type) return;
    if (*type < whole_number || *type > floating)
      throw cannot_read(path, fmt::format("pixel type of channel \"{}\" = {}, allowed {} (whole "
                                          "numbers), {} (half) and {} (float)",
                                          name, *type, whole_number, half, floating));
    file.go_to(file.at() + 12);
  }
}

/// Goes over a small picture: its sides, and 4 bytes for each of its pixels.
void pass_preview(Reader& file, std::int64_t size) {
  const auto width = file.integer().value_or(-1), height = file.integer().value_or(-1);
  if (width >= 0 && height >= 0 && width * height <= size)
    file.go_to(file.at() + 4 * width * height);
}

/// Whether a window has no side that is refused later anyway: OpenEXR makes room for its rows at once.
bool moderate_window(Reader& file) {
  std::array<std::int64_t, 4> corners{};
  for (auto& corner : corners) corner = file.integer().value_or(0);
  const auto [left, top, right, bottom] = corners;
  return static_cast<double>(std::max(right - left, bottom - top)) < most_texels_a_side;
}

/// Whether a tile is no larger than all of a small file may be: OpenEXR makes room for one at once.
bool moderate_tile(Reader& file) {
  const auto width = file.integer().value_or(-1), height = file.integer().value_or(-1);
  return width > 0 && height > 0 &&
         static_cast<double>(width) * static_cast<double>(height) <= most_numbers_of_any_file;
}

/// Whether an attribute ends where its own counts say.
bool honest(Reader& file, const std::filesystem::path& path, const std::string& type,
            std::int64_t size) {
  const std::int64_t end = file.at() + size;
  if (size < 0 || size > file.left()) return false;
  if (const auto bytes = bytes_of(type))
    return size == *bytes && (type != "box2i" || moderate_window(file)) &&
           (type != "tiledesc" || moderate_tile(file));
  if (type == "stringvector")
    pass_texts(file, end);
  else if (type == "chlist")
    pass_channels(file, path);
  else if (type == "preview")
    pass_preview(file, size);
  else
    return true;
  return file.good() && file.at() == end;
}

void require(bool holds, const std::filesystem::path& path, const std::string& what,
             std::int64_t size) {
  if (!holds)
    throw cannot_read(
        path, fmt::format("{} of {} bytes, allowed as many as it and the file hold", what, size));
}

void require_honest_exr(const std::filesystem::path& path, Reader& file) {
  constexpr std::int64_t of_several_parts = 0x1000;
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
    require(honest(file, path, type, *size), path, fmt::format("attribute \"{}\"", name), *size);
    file.go_to(begin + *size);
  }
}

void require_honest_png(const std::filesystem::path& path, Reader& file) {
  constexpr std::int64_t signature = 8, checksum = 4;
  file.go_to(signature);
  while (const auto length = file.length()) {
    const auto type = file.bytes();
    if (type.empty() || type == "IEND") return;
    require(*length <= file.left(), path, "chunk " + type, *length);
    file.go_to(file.at() + *length + checksum);
  }
}

}  // namespace

void require_honest_claims(const std::filesystem::path& path, std::string_view format) {
  Reader file(path);
  if (format == "openexr") require_honest_exr(path, file);
  if (format == "png") require_honest_png(path, file);
}

}  // namespace coppermoon::texture
