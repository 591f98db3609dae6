// SPDX-License-Identifier: MIT
#include "texture/openimageio/image_claims.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <fstream>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "texture/openimageio/image_input.h"

namespace coppermoon::texture {
namespace {

/// Reads a file item by item, and returns nothing past its end.
class Reader {
 public:
  explicit Reader(const std::filesystem::path& path)
      : file_(path, std::ios::binary), size_(std::filesystem::file_size(path)) {}

  /// Reads a name that ends in a zero byte. It is cut off after 256 letters, which is more than any valid name has.
  std::string name() {
    std::string text;
    for (int letter = file_.get(); letter > 0 && text.size() < 256; letter = file_.get())
      text += static_cast<char>(letter);
    return text;
  }
  /// Reads the given number of bytes as text; returns an empty text if fewer bytes are left.
  std::string bytes(std::size_t count) {
    std::string text(count, '\0');
    if (!file_.read(text.data(), static_cast<std::streamsize>(count))) text.clear();
    return text;
  }
  /// Reads an unsigned integer of the given number of bytes.
  std::optional<std::int64_t> natural(std::size_t count, std::endian order) {
    auto text = bytes(count);
    if (text.empty()) return {};
    if (order == std::endian::little) std::ranges::reverse(text);
    std::int64_t value = 0;
    for (const char byte : text) value = value << 8 | static_cast<unsigned char>(byte);
    return value;
  }
  /// Reads a signed integer of four bytes, little endian, as in OpenEXR.
  std::optional<std::int64_t> integer() {
    const auto value = natural(4, std::endian::little);
    if (!value) return {};
    return static_cast<std::int32_t>(*value);
  }
  std::int64_t at() { return static_cast<std::int64_t>(file_.tellg()); }
  std::int64_t left() { return static_cast<std::int64_t>(size_) - at(); }
  void go_to(std::int64_t place) { file_.seekg(place); }
  bool good() const { return file_.good(); }

 private:
  std::ifstream file_;
  std::uintmax_t size_;
};

/// Sizes [bytes] of attribute types with a fixed size. OpenEXR reads this many, whatever an attribute's header says.
const std::map<std::string_view, std::int64_t> fixed_sizes{
    {"box2f", 16},         {"box2i", 16},   {"chromaticities", 32},
    {"compression", 1},    {"double", 8},   {"envmap", 1},
    {"float", 4},          {"int", 4},      {"keycode", 28},
    {"lineOrder", 1},      {"m33d", 72},    {"m33f", 36},
    {"m44d", 128},         {"m44f", 64},    {"rational", 8},
    {"deepImageState", 1}, {"tiledesc", 9}, {"timecode", 8},
    {"v2d", 16},           {"v2f", 8},      {"v2i", 8},
    {"v3d", 24},           {"v3f", 12},     {"v3i", 12}};

/// Skips a list of channels. Each channel is a name, a pixel type and 12 more bytes; an empty name ends the list.
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

/// Whether an attribute ends where its size field says, and within the file.
bool honest(Reader& file, const std::filesystem::path& path, const std::string& type,
            std::int64_t size) {
  const std::int64_t end = file.at() + size;
  if (size < 0 || size > file.left()) return false;
  if (const auto fixed = fixed_sizes.find(type); fixed != fixed_sizes.end())
    return size == fixed->second;
  if (type != "chlist") return true;
  pass_channels(file, path);
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
  constexpr std::int64_t checksum = 4;
  if (file.bytes(8) != "\x89PNG\r\n\x1A\n") return;  // the reader will report that it is not a PNG
  while (const auto length = file.natural(4, std::endian::big)) {
    const auto type = file.bytes(4);
    if (type.empty() || type == "IEND") return;
    require(*length <= file.left(), path, "chunk " + type, *length);
    file.go_to(file.at() + *length + checksum);
  }
}

/// Skips a JPEG file's segments up to the frame header, and checks the picture's size that is given there.
void require_honest_jpeg(const std::filesystem::path& path, Reader& file) {
  constexpr std::int64_t signature = 2, fill = 0xFF, start_of_scan = 0xDA;
  const auto next = [&](std::size_t count) {
    return file.natural(count, std::endian::big).value_or(0);
  };
  file.go_to(signature);
  while (file.good()) {
    if (next(1) != fill) continue;
    auto marker = next(1);
    while (marker == fill) marker = next(1);
    const bool frame = marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 &&
                       marker != 0xCC,
               alone = marker <= 0x01 || (marker >= 0xD0 && marker <= 0xD9);
    if (marker == start_of_scan) return;
    if (alone) continue;
    const auto end = file.at() + next(2);
    if (frame) {
      next(1);  // skips the number of bits per sample
      const auto height = next(2), width = next(2), channels = next(1);
      return require_numbers(path, static_cast<double>(height * width * channels));
    }
    file.go_to(end);
  }
}

/// Checks the size of a GIF file's logical screen, because OpenImageIO counts its bytes in an int.
void require_honest_gif(const std::filesystem::path& path, Reader& file) {
  constexpr std::int64_t signature = 6, channels = 4;
  file.go_to(signature);
  const auto width = file.natural(2, std::endian::little).value_or(0),
             height = file.natural(2, std::endian::little).value_or(0);
  const auto numbers = static_cast<double>(width * height * channels);
  require_numbers(path, numbers);
  require_within(path, "numbers of a GIF", numbers, std::numeric_limits<int>::max());
}

}  // namespace

void require_within(const std::filesystem::path& path, std::string_view what, double value,
                    double most) {
  if (value <= most) return;
  throw cannot_read(path, fmt::format("{} = {:g}, allowed up to {:g}", what, value, most));
}

double most_numbers_in(const std::filesystem::path& path) {
  return most_numbers_of_any_file +
         most_numbers_a_byte * static_cast<double>(std::filesystem::file_size(path));
}

void require_numbers(const std::filesystem::path& path, double numbers) {
  require_within(path, "numbers, texels by channels", numbers, most_numbers);
  require_within(path, "numbers in a file so small", numbers, most_numbers_in(path));
}

void require_honest_claims(const std::filesystem::path& path, std::string_view format) {
  Reader file(path);
  if (format == "openexr") require_honest_exr(path, file);
  if (format == "png") require_honest_png(path, file);
  if (format == "jpeg") require_honest_jpeg(path, file);
  if (format == "gif") require_honest_gif(path, file);
}

}  // namespace coppermoon::texture
