// SPDX-License-Identifier: MIT
#include "texture/seal.h"

#include "baker/texture/scratch_folder.h"
#include "support/testing.h"
#include "support/thorough.h"
#include "texture/openimageio/encode.h"
#include "texture/write_image.h"

namespace coppermoon::texture::seal_test {

class Seal : public ScratchFolder {
 protected:
  Seal() : image_(16, 16, {"R", "G", "B"}) {
    for (std::size_t i = 0; i < image_.values.size(); ++i)
      image_.values[i] = static_cast<float>(i % 97) / 8;
  }

  /// No byte of the file may be another: of those at its beginning, where the header is, all or a fifth, and some of the
  /// others.
  void expect_every_byte_counts(const std::filesystem::path& path) const {
    const auto whole = bytes_of(path);
    EXPECT_TRUE(is_sealed(path));
    const auto other = in_folder("spoilt.exr");
    const std::size_t step = support::thorough() ? 1 : 5;
    for (std::size_t at = 0; at < whole.size(); at += step * (at < 600 ? 1 : 37)) {
      auto bytes = whole;
      bytes[at] = static_cast<char>(bytes[at] ^ 1);
      std::ofstream(other, std::ios::binary) << bytes;
      EXPECT_FALSE(is_sealed(other)) << "byte " << at;
    }
    for (const auto& bytes : {whole + "x", whole.substr(0, whole.size() - 1), std::string()}) {
      std::ofstream(other, std::ios::binary) << bytes;
      EXPECT_FALSE(is_sealed(other)) << bytes.size() << " bytes";
    }
  }

  Image image_;
};

TEST_F(Seal, OfAFileOfOneImageSeesEveryByte) {
  for (const bool packed : {true, false}) {
    write_exr(in_folder("one.exr"), image_, {}, {.packed = packed});
    expect_every_byte_counts(in_folder("one.exr"));
  }
}

TEST_F(Seal, OfPartsSeesAllOfThem) {
  const Layout layout{image_.width, image_.height, image_.channels};
  const std::vector<Part> parts{{"lit", layout, rows_of(image_)},
                                {"direct", layout, rows_of(image_)}};
  write_exr(in_folder("parts.exr"), parts, {});
  expect_every_byte_counts(in_folder("parts.exr"));
}

TEST_F(Seal, OfMipmapsSeesAllOfThem) {
  write_mipmapped(in_folder("moon.tx"), {16, 16, image_.channels}, rows_of(image_), {});
  expect_every_byte_counts(in_folder("moon.tx"));
}

TEST_F(Seal, IsOnNothingElse) {
  EXPECT_FALSE(is_sealed(in_folder("none.exr")));
  EXPECT_FALSE(is_sealed(in_folder(".")));
  write_png(in_folder("a.png"), Image(1, 1, {"Y"}), 8);
  EXPECT_FALSE(is_sealed(in_folder("a.png")));
}

}  // namespace coppermoon::texture::seal_test
