// SPDX-License-Identifier: MIT
#include "texture/write_usdz.h"

#include <zlib.h>

#include <bit>
#include <cstdint>

#include "files/whole_file.h"
#include "texture/openimageio/picture_on_globe.h"
#include "texture/usd_text.h"

namespace coppermoon::texture {
namespace {

constexpr const char* texture_lines =
    "                asset inputs:file = @moon.png@\n"
    "                token inputs:sourceColorSpace = \"sRGB\"\n";

static_assert(std::endian::native == std::endian::little, "numbers are copied as they stand");

template <class Number>
void append(std::string& bytes, Number number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

/// A ZIP archive of uncompressed files. The contents of each file start at a multiple of 64 bytes.
class Archive {
 public:
  void add(const std::string& name, const std::string& content) {
    constexpr std::size_t alignment = 64, head = 30, extra_head = 4;
    const auto offset = static_cast<std::uint32_t>(bytes_.size());
    const auto ends = bytes_.size() + head + name.size() + extra_head;
    const auto padding = static_cast<std::uint16_t>((alignment - ends % alignment) % alignment);
    const auto shared = facts_of(name, content);
    append<std::uint32_t>(bytes_, 0x04034b50);
    bytes_ += shared;
    append<std::uint16_t>(bytes_, extra_head + padding);
    bytes_ += name;
    append<std::uint16_t>(bytes_, 0x1986);  // identifier that USD's own writer uses for padding
    append<std::uint16_t>(bytes_, padding);
    bytes_.append(padding, '\0');
    bytes_ += content;
    append<std::uint32_t>(directory_, 0x02014b50);
    append<std::uint16_t>(directory_, version);
    directory_ += shared;
    append<std::uint16_t>(directory_, 0);  // no extra field
    append<std::uint16_t>(directory_, 0);  // no comment
    append<std::uint16_t>(directory_, 0);  // starts on disk 0
    append<std::uint16_t>(directory_, 0);
    append<std::uint32_t>(directory_, 0);
    append<std::uint32_t>(directory_, offset);
    directory_ += name;
    ++files_;
  }

  std::string whole() const {
    auto bytes = bytes_ + directory_;
    append<std::uint32_t>(bytes, 0x06054b50);
    append<std::uint32_t>(bytes, 0);  // two disk numbers, both 0
    append<std::uint16_t>(bytes, files_);
    append<std::uint16_t>(bytes, files_);
    append(bytes, static_cast<std::uint32_t>(directory_.size()));
    append(bytes, static_cast<std::uint32_t>(bytes_.size()));
    append<std::uint16_t>(bytes, 0);  // no comment
    return bytes;
  }

 private:
  static constexpr std::uint16_t version = 10, first_day_of_zip = 0x0021;  // stands for 1980-01-01

  /// Fields that are equal in a file's header and in its directory entry. The last is the length of the file's name.
  static std::string facts_of(const std::string& name, const std::string& content) {
    const auto size = static_cast<std::uint32_t>(content.size());
    const auto sum = ::crc32_z(0, reinterpret_cast<const Bytef*>(content.data()), content.size());
    std::string facts;
    append(facts, version);
    append<std::uint16_t>(facts, 0);  // no flags
    append<std::uint16_t>(facts, 0);  // not compressed
    append<std::uint16_t>(facts, 0);  // time: midnight
    append(facts, first_day_of_zip);
    append(facts, static_cast<std::uint32_t>(sum));
    append(facts, size);
    append(facts, size);
    append(facts, static_cast<std::uint16_t>(name.size()));
    return facts;
  }

  std::string bytes_, directory_;
  std::uint16_t files_ = 0;
};

}  // namespace

void write_usdz(const std::filesystem::path& path, const Image& developed) {
  Archive archive;
  const auto picture = picture_on_globe(path, developed);
  archive.add("moon.usda", usd_layer() +
                               "\ndef Xform \"Moon\" (\n    kind = \"component\"\n)\n{\n" +
                               usd_mesh() + "\n" + usd_looks(texture_lines) + "}\n");
  archive.add("moon.png", picture);
  files::write_whole(path, archive.whole());
}

}  // namespace coppermoon::texture
