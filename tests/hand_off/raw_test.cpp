// SPDX-License-Identifier: MIT
// Raw converters, given the sensor's mosaic: LibRaw's own and darktable, whose decoder is another.
#include "support/program.h"
#include "texture/read_image.h"

namespace coppermoon::hand_off::raw_test {

class Raw : public ProgramTest {
 protected:
  /// A deep eclipse, copper in one corner of the Moon and pale in the other, nowhere clipped.
  Raw() {
    expect_done(
        coppermoon("still 2008-02-21T03:08:26Z --at 42.86,-73.77 --albedo-map built-in --rays 60 "
                   "--iso 800 --time 0.5 --width 600 --height 400 --camera 400mm --raw a.dng "
                   "--seeing 2 --focal-length 1200 -o a.png"));
  }

  /// Means of squares of ten pixels, which all demosaicing leaves as they are, but at the Moon's edge.
  void expect_same_light(const texture::Image& ours, const texture::Image& theirs) const {
    ASSERT_EQ(theirs.width, ours.width);
    ASSERT_EQ(theirs.height, ours.height);
    constexpr std::size_t side = 10;
    int lit = 0, dark = 0;
    for (std::size_t r = 0; r + side <= ours.height; r += side)
      for (std::size_t c = 0; c + side <= ours.width; c += side) {
        double least = 1, most = 0, mean[2][3] = {};
        for (std::size_t y = r; y < r + side; ++y)
          for (std::size_t x = c; x < c + side; ++x) {
            least = std::min<double>(least, ours(y, x, 0));
            most = std::max<double>(most, ours(y, x, 0));
            for (std::size_t k = 0; k < 3; ++k) {
              mean[0][k] += ours(y, x, k) / (side * side);
              mean[1][k] += theirs(y, x, k) / (side * side);
            }
          }
        const double red = mean[0][0];
        if (most > 0.01 && least < most / 3) continue;
        ++(red > 0.01 ? lit : dark);
        for (std::size_t k = 0; k < 3; ++k)
          EXPECT_WITHIN(mean[1][k], mean[0][k], 0.02 * red + 1e-3,
                        "a demosaiced edge of a mare within the square, light lost below 0")
              << "channel " << k << " at " << r << ", " << c;
      }
    EXPECT_GT(lit, 200) << "the Moon's disc is 180 pixels wide";
    EXPECT_GT(dark, 1500) << "of 2400 squares";
  }
};

TEST_F(Raw, LibRawsProgramSeesTheSameLight) {
  const auto done = run("dcraw_emu -T -4 -o 1 -q 3 a.dng");
  ASSERT_EQ(done.status, 0) << done.err;
  expect_same_light(texture::read_light(here("a.dng")), texture::read_image(here("a.dng.tiff")));
}

TEST_F(Raw, DarktableSeesTheSameLight) {
  const auto done = run(words_of(
      "darktable-cli a.dng b.tif --icc-type LIN_REC709 --core --configdir {} --library :memory: "
      "--conf plugins/darkroom/workflow=none --conf plugins/imageio/format/tiff/bpp=32",
      here("darktable")));
  ASSERT_EQ(done.status, 0) << done.err;
  expect_same_light(texture::read_light(here("a.dng")), texture::read_image(here("b.tif")));
}

}  // namespace coppermoon::hand_off::raw_test
