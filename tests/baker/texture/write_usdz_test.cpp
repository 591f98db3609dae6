// SPDX-License-Identifier: MIT
#include "texture/write_usdz.h"

#include <zlib.h>
#include <cstring>

#include "baker/texture/scratch_folder.h"
#include "support/testing.h"
#include "texture/read_image.h"

namespace write_usdz_test {

using namespace coppermoon::texture;

using WriteUsdz = ScratchFolder;

Image picture() {
  Image image(64, 32, {"R", "G", "B"});
  for (std::size_t i = 0; i < image.values.size(); ++i)
    image.values[i] = static_cast<float>(i * 7919 % 256) / 255;
  return image;
}

template <class Number>
Number number_at(const std::string& bytes, std::size_t at) {
  Number number = 0;
  std::memcpy(&number, bytes.data() + at, sizeof number);
  return number;
}

/// An archive taken apart from its end, as ZIP's standard says.
struct Archive {
  struct File {
    std::string name, content;
    std::size_t begin;
  };
  std::vector<File> files{};

  explicit Archive(const std::string& bytes) {
    const auto end = bytes.size() - 22;
    EXPECT_EQ(bytes.substr(end, 4), "PK\5\6");
    const auto count = number_at<std::uint16_t>(bytes, end + 10);
    EXPECT_EQ(number_at<std::uint32_t>(bytes, end + 12) + number_at<std::uint32_t>(bytes, end + 16),
              end);
    std::size_t at = number_at<std::uint32_t>(bytes, end + 16);
    for (int i = 0; i < count; ++i) add(bytes, at);
    EXPECT_EQ(at, end);
  }

 private:
  void add(const std::string& bytes, std::size_t& at) {
    EXPECT_EQ(bytes.substr(at, 4), "PK\1\2");
    EXPECT_EQ(number_at<std::uint16_t>(bytes, at + 10), 0) << "stored as it is";
    const auto sum = number_at<std::uint32_t>(bytes, at + 16),
               size = number_at<std::uint32_t>(bytes, at + 20);
    EXPECT_EQ(number_at<std::uint32_t>(bytes, at + 24), size);
    const auto length = number_at<std::uint16_t>(bytes, at + 28);
    const std::size_t head = number_at<std::uint32_t>(bytes, at + 42);
    EXPECT_EQ(bytes.substr(head, 4), "PK\3\4");
    EXPECT_EQ(bytes.substr(head + 4, 24), bytes.substr(at + 6, 24)) << "both tell the same";
    const auto begin = head + 30 + length + number_at<std::uint16_t>(bytes, head + 28);
    files.push_back({bytes.substr(at + 46, length), bytes.substr(begin, size), begin});
    const auto& content = files.back().content;
    EXPECT_EQ(::crc32_z(0, reinterpret_cast<const Bytef*>(content.data()), content.size()), sum);
    at += 46 + length;
  }
};

TEST_F(WriteUsdz, IsAnArchiveOfALayerAndAPictureFromMultiplesOf64BytesOn) {
  write_usdz(in_folder("moon.usdz"), picture());
  const Archive archive(bytes_of(in_folder("moon.usdz")));
  ASSERT_EQ(archive.files.size(), 2U);
  EXPECT_EQ(archive.files[0].name, "moon.usda") << "the first file is the layer that is opened";
  EXPECT_EQ(archive.files[1].name, "moon.png");
  for (const auto& held : archive.files) EXPECT_EQ(held.begin % 64, 0U) << held.name;
  EXPECT_EQ(files_in_folder(), 1U);
}

TEST_F(WriteUsdz, HoldsThePictureTexelByTexel) {
  const auto image = picture();
  write_usdz(in_folder("moon.usdz"), image);
  const Archive archive(bytes_of(in_folder("moon.usdz")));
  const auto back = read_image(file("held.png", archive.files.at(1).content));
  ASSERT_EQ(back.values.size(), image.values.size());
  for (std::size_t i = 0; i < image.values.size(); ++i)
    EXPECT_WITHIN(back.values[i], image.values[i], 1e-6F, "they are 256ths; float's rounding");
}

TEST_F(WriteUsdz, ShinesByThePictureInSrgb) {
  write_usdz(in_folder("moon.usdz"), picture());
  const auto layer = Archive(bytes_of(in_folder("moon.usdz"))).files.at(0).content;
  for (const char* line :
       {"#usda 1.0\n", "defaultPrim = \"Moon\"", "asset inputs:file = @moon.png@",
        "token inputs:sourceColorSpace = \"sRGB\"", "color3f inputs:diffuseColor = (0, 0, 0)",
        "rel material:binding = </Moon/Looks/Moonlight>",
        "color3f inputs:emissiveColor.connect = </Moon/Looks/Moonlight/Texture.outputs:rgb>"})
    EXPECT_SAYS(layer, line);
}

TEST_F(WriteUsdz, TheSameInputGivesTheSameBytes) {
  write_usdz(in_folder("a.usdz"), picture());
  write_usdz(in_folder("b.usdz"), picture());
  EXPECT_EQ(bytes_of(in_folder("a.usdz")), bytes_of(in_folder("b.usdz")));
}

TEST_F(WriteUsdz, RefusesWhatViewersCannotShow) {
  EXPECT_ERROR(write_usdz(in_folder("moon.usdz"), Image(64, 30, {"Y"})),
               "moon.usdz: picture of 64 x 30 texels, allowed 2:1");
  EXPECT_EQ(files_in_folder(), 0U);
}

}  // namespace write_usdz_test
