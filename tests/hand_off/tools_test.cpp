// SPDX-License-Identifier: MIT
// OpenImageIO's and OpenColorIO's own programs, given what coppermoon makes.
#include <OpenImageIO/imageio.h>

#include "support/program.h"
#include "texture/image.h"

namespace coppermoon::hand_off::tools_test {

class Tools : public ProgramTest {
 protected:
  void bake(Words more) const {
    expect_done(
        coppermoon("bake 2018-07-27T19:20:00Z --albedo-map built-in --texture-width 512" + more));
  }

  std::string said(const Words& words) const {
    const auto outcome = run(words);
    EXPECT_EQ(outcome.status, 0) << words.front() << ": " << outcome.err << outcome.out;
    return outcome.out;
  }

  texture::Image level(const std::string& name, int number) const {
    const auto input = OIIO::ImageInput::open(here(name));
    EXPECT_TRUE(input && input->seek_subimage(0, number)) << OIIO::geterror();
    const auto spec = input->spec();
    texture::Image image(static_cast<std::size_t>(spec.width),
                         static_cast<std::size_t>(spec.height), spec.channelnames);
    EXPECT_TRUE(input->read_image(0, number, 0, 3, OIIO::TypeDesc::FLOAT, image.values.data()));
    return image;
  }
};

TEST_F(Tools, IinfoKnowsAllThatAFileSays) {
  bake("-o moon_acescg.exr -o moon_lin_rec709.tx -o moon_srgb.png --passes --spectral 20");
  const auto exr = said("iinfo -v -a moon_acescg.exr");
  for (const char* word :
       {"6 subimages", "\"lit\"", "\"direct\"", "\"refracted\"", "\"irradiance\"",
        "\"reflectance\"", "\"albedo\"", "S0.390,000000nm", "spectralLayoutVersion: \"1.0\"",
        "chromaticities: 0.713, 0.293", "DateTime: \"2018:07:27 19:20:00\""})
    EXPECT_SAYS(exr, word);
  const auto tx = said("iinfo -v moon_lin_rec709.tx");
  for (const char* word : {"half openexr", "512x256 256x128 128x64", "tile size: 64 x 64",
                           "wrapmodes: \"periodic,clamp\""})
    EXPECT_SAYS(tx, word);
  EXPECT_SAYS(said("iinfo moon_srgb.png"), "uint16 png");
}

TEST_F(Tools, OiiotoolReadsEveryTexel) {
  bake("-o moon.exr -o moon.tx -o moon.png --passes");
  for (const char* file : {"moon.exr", "moon.tx", "moon.png"}) {
    const auto counts = said(words_of("oiiotool -a {} --printstats", file));
    EXPECT_SAYS(counts, "NanCount: 0");
    EXPECT_SAYS(counts, "InfCount: 0");
  }
}

TEST_F(Tools, MaketxMakesTheSameMipmaps) {
  bake("-o moon.exr -o ours.tx");
  said("maketx moon.exr --format exr -d half --swrap periodic --twrap clamp -o theirs.tx");
  for (const int number : {0, 1, 2, 3}) {
    const auto ours = level("ours.tx", number), theirs = level("theirs.tx", number);
    ASSERT_EQ(ours.values.size(), theirs.values.size());
    for (std::size_t i = 0; i < ours.values.size(); ++i)
      EXPECT_WITHIN(ours.values[i], theirs.values[i], 2e-3 * ours.values[i] + 1e-6,
                    "both take means of four; theirs of halves, level by level, 5e-4 each");
  }
}

TEST_F(Tools, OciocheckPassesTheConfiguration) {
  const std::string config = COPPERMOON_TEST_DATA "/../colour/config.ocio";
  EXPECT_SAYS(said({"ociocheck", "--iconfig", config}), "passed");
}

}  // namespace coppermoon::hand_off::tools_test
