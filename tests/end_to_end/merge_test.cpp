// SPDX-License-Identifier: MIT
// Photographs that are to become one, and frames that are to become pictures: what they must be.
#include <OpenImageIO/imageio.h>

#include "support/program.h"
#include "texture/read_image.h"
#include "texture/write_image.h"

namespace coppermoon::end_to_end::merge_test {

using texture::Attributes;

const std::string recipe =
    "instant = \"2018-07-27T20:40:00Z\"\ncloud-cover = 0.3\ntime = 1\niso = 100\nnoise-seed = 1\n";

class Merge : public ProgramTest {
 protected:
  /// A photograph of 4 x 2 pixels, of a second at f/8.
  void photograph(const char* name, Attributes says = {}) const {
    texture::Image image(4, 2, {"R", "G", "B", "valid"});
    std::ranges::fill(image.values, 1.F);
    says.try_emplace("expTime", 1.F), says.try_emplace("aperture", 8.F);
    texture::write_exr(here(name), image, says, {.type = texture::ExrType::floating});
  }

  void oiiotool(const Words& words) const {
    Words all{"oiiotool"};
    all += words;
    ASSERT_EQ(run(all).status, 0);
  }

  const Words merged = "merge a.exr b.exr -o c.exr";

  void expect_merged() const {
    expect_done(coppermoon(merged));
    EXPECT_EQ(texture::read_image(here("c.exr"))(0, 0, 0), 1);
  }

  void expect_refused(const std::string& why) const {
    std::filesystem::remove(here("c.exr"));
    expect_refusal(merged, why);
  }
};

TEST_F(Merge, TakesExposuresOfOneScene) {
  photograph("a.exr", {{"coppermoon:recipe", recipe}, {"capDate", "2018:07:27 20:40:00"}});
  auto other = recipe;
  other.replace(other.find("time = 1"), 8, "time = 8");
  other.replace(other.find("noise-seed = 1"), 14, "noise-seed = 5");
  photograph("b.exr", {{"coppermoon:recipe", other}, {"capDate", "2018:07:27 20:41:00"}});
  expect_merged();
  photograph("b.exr", {{"capDate", "0000:00:00 00:00:00"}});  // a clock that was not set
  expect_merged();
}

TEST_F(Merge, RefusesPhotographsMoreThanAMinuteApart) {
  photograph("a.exr", {{"capDate", "2018:07:27 20:40:00"}});
  photograph("b.exr", {{"capDate", "2018:07:27 21:40:00"}});
  expect_refused("b.exr: taken 3600 s after a.exr, allowed 60 s");
  photograph("b.exr", {{"capDate", "2018:07:27 20:38:59"}});
  expect_refused("b.exr: taken 61 s before a.exr, allowed 60 s");
  photograph("b.exr", {{"capDate", "yesterday"}});
  expect_refused("b.exr: its header's date = yesterday, allowed YYYY:MM:DD HH:MM:SS");
}

TEST_F(Merge, RefusesPhotographsOfOtherScenes) {
  photograph("a.exr", {{"coppermoon:recipe", recipe}});
  auto other = recipe;
  other.replace(other.find("0.3"), 3, "0.5");
  photograph("b.exr", {{"coppermoon:recipe", other}});
  expect_refused("b.exr: its recipe has cloud-cover = 0.5, allowed 0.3 as a.exr");
  photograph("b.exr", {{"coppermoon:recipe", recipe + "field = 2.0\n"}});
  expect_refused("b.exr: its recipe has field = 2, allowed none as a.exr");
  photograph("b.exr", {{"coppermoon:recipe", recipe + "\n[atmosphere]\nmodel = \"paper\"\n"}});
  expect_refused("b.exr: its recipe has atmosphere = 'paper', allowed none as a.exr");
}

TEST_F(Merge, RefusesPhotographsOfOtherMeaning) {
  photograph("a.exr", {{"coppermoon:colour_space", "lin_rec709_scene"}});
  photograph("b.exr", {{"coppermoon:colour_space", "acescg"}});
  expect_refused("b.exr: coppermoon:colour_space = acescg, allowed lin_rec709_scene as a.exr");
}

TEST_F(Merge, RefusesOtherCropsAndWindows) {
  photograph("a.exr");
  oiiotool("a.exr --cut 3x2+0+0 -o b.exr");
  expect_refused("b.exr: display window of 3 x 2 pixels, allowed 4 x 2 pixels as a.exr");
  oiiotool("a.exr --crop 3x2+0+0 -o b.exr");
  expect_refused("b.exr: data window of 3 x 2 pixels, allowed 4 x 2 pixels as a.exr");
  oiiotool("a.exr --origin +1+0 -o b.exr");
  expect_refused(
      "b.exr: data window of 4 x 2 pixels from 1, 0, allowed 4 x 2 pixels from 0, 0 as a.exr");
}

TEST_F(Merge, RefusesPixelsThatAreNeitherValidNorNot) {
  photograph("a.exr");
  const auto with = [&](const std::vector<float>& pixel) {
    OIIO::ImageSpec spec(4, 2, 4, OIIO::TypeDesc::FLOAT);
    spec.channelnames = {"R", "G", "B", "valid"};
    std::vector<float> values(32, 1.F);
    std::ranges::copy(pixel, values.begin() + 4 * 6);
    const auto output = OIIO::ImageOutput::create("openexr");
    ASSERT_TRUE(output->open(here("b.exr").string(), spec));
    ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, values.data()));
  };
  for (const auto& [valid, name] : std::vector<std::pair<float, std::string>>{
           {5.F, "5"}, {-1.F, "-1"}, {std::numeric_limits<float>::quiet_NaN(), "nan"}}) {
    with({1, 1, 1, valid});
    expect_refused("b.exr: valid at row 1, column 2 = " + name + ", allowed 0 to 1");
  }
  with({1, std::numeric_limits<float>::infinity(), 1, 0});
  expect_refused("b.exr: G at row 1, column 2 = inf, allowed what is finite");
}

/// A frame of 4 x 2 pixels, red to the left.
class Develop : public ProgramTest {
 protected:
  void frame(const std::vector<std::string>& channels, const Attributes& says = {}) const {
    texture::Image image(4, 2, channels);
    for (std::size_t i = 0; i < image.values.size(); ++i)
      image.values[i] = i % channels.size() == 0 && i / channels.size() % 4 < 2 ? 10.F : 0.F;
    texture::write_exr(here("frame.exr"), image, says);
  }
  Outcome developed(const Words& more = {}) const {
    Words words = "develop frame.exr --time 1 -o picture.png";
    words += more;
    return coppermoon(words);
  }
};

TEST_F(Develop, TakesChannelsByTheirNamesAlone) {
  for (const auto& channels : std::vector<std::vector<std::string>>{
           {"Y", "RY", "BY"}, {"B", "A", "Z"}, {"X", "Y", "Z"}, {"Y"}}) {
    frame(channels);
    const auto outcome = developed();
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(outcome.err.starts_with("coppermoon: frame.exr: channels ")) << outcome.err;
    EXPECT_TRUE(outcome.err.ends_with(", allowed R, G, B\n")) << outcome.err;
  }
  frame({"X", "Y", "Z"}, {{"coppermoon:colour_space", "lin_ciexyzd65_scene"}});
  expect_done(developed());
  frame({"R", "G", "B"}, {{"coppermoon:colour_space", "lin_ciexyzd65_scene"}});
  EXPECT_EQ(developed().err, "coppermoon: frame.exr: channels R, G, B, allowed X, Y, Z\n");
}

TEST_F(Develop, ShowsTheDisplayWindow) {
  frame({"R", "G", "B"});
  ASSERT_EQ(run("oiiotool frame.exr --crop 3x1+1+1 -o frame.exr").status, 0);
  expect_done(developed());
  const auto picture = texture::read_image(here("picture.png"));
  ASSERT_EQ(picture.width, 4);
  ASSERT_EQ(picture.height, 2);
  for (std::size_t r = 0; r < 2; ++r)
    for (std::size_t c = 0; c < 4; ++c)
      EXPECT_EQ(picture(r, c, 0) > 0.1F, r == 1 && c == 1) << r << ", " << c;
}

TEST_F(Develop, KeepsWhatAFramesHeaderSaysOfTheScene) {
  frame({"R", "G", "B"}, {{"coppermoon:recipe", recipe}, {"capDate", "2018:07:27 20:40:00"}});
  expect_done({developed("--camera 400mm --photograph a.exr").status, {}, {}});
  EXPECT_EQ(texture::read_attribute(here("a.exr"), "coppermoon:recipe"), recipe);
  EXPECT_EQ(texture::read_attribute(here("a.exr"), "capDate"), "2018:07:27 20:40:00");
}

}  // namespace coppermoon::end_to_end::merge_test
