// SPDX-License-Identifier: MIT
// The reader that OpenImageIO loads, in a host of our own and in OpenImageIO's tools.
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagecache.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/texture.h>
#include <cstdlib>
#include <thread>

#include "support/program.h"

namespace coppermoon::end_to_end::image_reader_test {

/// Sunlight alone: a texture in a fraction of a second.
constexpr std::string_view recipe =
    "instant = \"2018-07-27T19:40:17Z\"\n"
    "unshadowed = true\n"
    "albedo-map = \"built-in\"\n"
    "texture-width = 256\n";

/// One level of an image, as any host reads it.
std::vector<float> texels_of(const std::string& name, int level = 0) {
  const auto input = OIIO::ImageInput::open(name);
  if (!input || !input->seek_subimage(0, level)) return {};
  std::vector<float> texels(input->spec().image_pixels() * 3);
  return input->read_image(0, level, 0, 3, OIIO::TypeDesc::FLOAT, texels.data())
             ? texels
             : std::vector<float>{};
}

class ImageReader : public ProgramTest {
 protected:
  ImageReader() {
    ::setenv("COPPERMOON_CACHE", here("cache/coppermoon").c_str(), 1);
    ::setenv("OIIO_LIBRARY_PATH", COPPERMOON_READERS, 1);
    OIIO::attribute("plugin_searchpath", COPPERMOON_READERS);
    moon = file("moon.eclipse", recipe).string();
  }

  std::size_t textures_kept() const {
    std::error_code none;
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(here("cache/coppermoon"), none))
      if (entry.path().extension() == ".tx") ++count;
    return count;
  }

  /// What a host is told when it opens a file that cannot be opened.
  static std::string why_not(const std::string& name) {
    OIIO::geterror();
    EXPECT_FALSE(OIIO::ImageInput::open(name)) << name;
    return OIIO::geterror();
  }

  /// A small recipe that takes another image for its map.
  std::string with_map(std::string_view name, const std::string& map) const {
    const std::string rest =
        "instant = \"2018-07-27T19:40:17Z\"\nunshadowed = true\ntexture-width = 64\n";
    return file(name, "albedo-map = \"" + map + "\"\n" + rest).string();
  }

  /// A grey map, the half of it that is brighter to the west or to the east.
  void write_map(std::string_view name, bool west) const {
    const auto output = OIIO::ImageOutput::create("png");
    std::vector<float> texels(16 * 8);
    for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = (i % 16 < 8) == west ? 0.8F : 0.4F;
    const OIIO::ImageSpec spec(16, 8, 1, OIIO::TypeDesc::UINT8);
    ASSERT_TRUE(output && output->open(here(name), spec) &&
                output->write_image(OIIO::TypeDesc::FLOAT, texels.data()) && output->close());
  }

  std::string moon;
};

TEST_F(ImageReader, GivesTheTexelsThatBakeWrites) {
  file("moon.eclipse",
       "instant = \"2018-07-27 U2+10min\"\nalbedo-map = \"built-in\"\n"
       "texture-width = 256\nquality = \"draft\"\n");
  expect_done(
      coppermoon("bake 2018-07-27T19:40:17Z --albedo-map built-in --texture-width 256 --quality "
                 "draft -o flat.exr -o levels.tx"));
  const auto flat = texels_of(here("flat.exr"));
  ASSERT_EQ(flat.size(), 256u * 128 * 3);
  EXPECT_EQ(texels_of(moon), flat);
  for (const int level : {1, 4, 7})
    EXPECT_EQ(texels_of(moon, level), texels_of(here("levels.tx"), level)) << level;
  EXPECT_TRUE(texels_of(moon, 99).empty());
}

TEST_F(ImageReader, BakesOnceForAllThatReadAtOnce) {
  testing::internal::CaptureStdout();
  std::vector<std::vector<float>> read(6);
  {
    std::vector<std::jthread> hosts;
    for (auto& texels : read) hosts.emplace_back([&] { texels = texels_of(moon); });
  }
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  for (const auto& texels : read) EXPECT_EQ(texels, read.front());
  EXPECT_FALSE(read.front().empty());
  EXPECT_EQ(textures_kept(), 1u);
}

TEST_F(ImageReader, BakesAnewWhatDependsOnSomethingElse) {
  const auto first = texels_of(moon);
  expect_done(
      coppermoon("bake 2018-07-27T19:40:17Z --unshadowed --albedo-map built-in --texture-width 64 "
                 "-o one.png"));
  const auto with_map = std::string(recipe.substr(0, recipe.find("albedo"))) +
                        "albedo-map = \"one.png\"\ntexture-width = 256\n";
  file("moon.eclipse", with_map);  // one.png stands beside the recipe
  const auto second = texels_of(moon);
  EXPECT_NE(second, first);
  expect_done(
      coppermoon("bake 2018-07-30T19:40:17Z --unshadowed --albedo-map built-in --texture-width 64 "
                 "-o other.png"));
  std::filesystem::rename(here("other.png"), here("one.png"));
  EXPECT_NE(texels_of(moon), second);
  EXPECT_EQ(textures_kept(), 3u);
}

/// A recipe whose map is a recipe: reading the one bakes the other, into the same folder.
TEST_F(ImageReader, BakesFromARecipeThatIsAMap) {
  const auto first = with_map("first.eclipse", "second.eclipse");
  with_map("second.eclipse", "map.png");
  write_map("map.png", true);
  const auto texels = texels_of(first);
  ASSERT_EQ(texels.size(), 64u * 32 * 3);
  EXPECT_EQ(textures_kept(), 2u);
  write_map("map.png", false);  // both recipes are as they were
  EXPECT_NE(texels_of(first), texels);
  EXPECT_EQ(textures_kept(), 4u);
}

TEST_F(ImageReader, RefusesARecipeThatIsMadeFromItself) {
  const auto first = with_map("first.eclipse", "second.eclipse");
  with_map("second.eclipse", "first.eclipse");
  const auto why = why_not(first);
  const auto path = std::filesystem::canonical(first).string();
  EXPECT_SAYS(why, path + ": its map is made from itself: " + path + " -> ");
  EXPECT_SAYS_NOT(why, '\n');
  EXPECT_EQ(textures_kept(), 0u);
}

TEST_F(ImageReader, HeedsOptionsBehindTheName) {
  const auto input = OIIO::ImageInput::open(moon + "?texture-width=128&space=acescg");
  ASSERT_TRUE(input) << OIIO::geterror();
  EXPECT_EQ(input->spec().width, 128);
  EXPECT_EQ(input->spec().get_string_attribute("coppermoon:colour_space"), "acescg");
  EXPECT_SAYS(why_not(moon + "?texture-width=127"), "allowed even numbers")
      << why_not(moon + "?texture-width=127");
}

TEST_F(ImageReader, StandsOnACommandThatSaysTheMomentOnce) {
  const Words words =
      "bake 2018-07-27 --unshadowed --albedo-map built-in --texture-width 64 --cache kept";
  const auto first = coppermoon(words), again = coppermoon(words);
  EXPECT_EQ(first.err,
            "coppermoon: the greatest eclipse of 2018-07-27 is 2018-07-27 20:21:45 UTC\n");
  EXPECT_EQ(again.err, "") << "nothing is computed";
  EXPECT_EQ(again.out, first.out);
  EXPECT_EQ(coppermoon("bake 2018-08-27 --cache kept").status, 1);
  for (const char* part : {"--shard=1/8", "--keep=sums.json", "--add=sums.json"})
    EXPECT_EQ(coppermoon(words + Words{part}).status, 2)
        << part << ": another number of photons, or a file that a kept texture would not bring";
}

TEST_F(ImageReader, KeepsNoTextureThatIsBrokenOrALink) {
  const Words words =
      "bake 2018-07-27T19:40:17Z --unshadowed --albedo-map built-in --texture-width 64 --cache "
      "kept";
  const auto said = coppermoon(words).out;
  const auto texture = here(said.substr(0, said.find('\n')));
  const auto whole = text_of(texture);
  ASSERT_FALSE(whole.empty());
  const auto precious = file("precious.txt", "mine");
  const std::vector<std::function<void()>> harm{
      [&] { std::filesystem::resize_file(texture, whole.size() / 2); },
      [&] { std::filesystem::resize_file(texture, 0); },
      [&] {
        std::filesystem::remove(texture);
        std::filesystem::create_symlink(precious, texture);
      }};
  for (std::size_t i = 0; i < harm.size(); ++i) {
    harm[i]();
    expect_done(coppermoon(words));
    EXPECT_TRUE(std::filesystem::is_regular_file(std::filesystem::symlink_status(texture))) << i;
    EXPECT_EQ(text_of(texture), whole) << i;
  }
  EXPECT_EQ(text_of(precious), "mine");
}

TEST_F(ImageReader, LetsNoNameWriteAFile) {
  const auto before = listing();
  for (const char* option : {"output", "keep", "recipe", "cache", "albedo-map"})
    EXPECT_SAYS(why_not(moon + "?" + option + "=evil.exr"), "allowed at, instant") << option;
  EXPECT_EQ(listing(), before);
}

TEST_F(ImageReader, SaysInOneLineWhatIsWrong) {
  const std::string no_eclipse = file("none.eclipse", "instant = \"2018-08-27\"\n").string();
  EXPECT_SAYS(why_not(no_eclipse), "no lunar eclipse is greatest on that day");
  const std::string no_recipe = file("bytes.eclipse", std::string("\xff\0\x01", 3)).string();
  const std::string no_moment = file("empty.eclipse", "").string();
  for (const auto& name : {no_eclipse, no_recipe, no_moment, here("absent.eclipse").string(),
                           here().string() + ".eclipse", moon + "?=", moon + "?a=b=c&"}) {
    const auto why = why_not(name);
    EXPECT_FALSE(why.empty()) << name;
    EXPECT_SAYS_NOT(why, '\n');
  }
  EXPECT_EQ(textures_kept(), 0u);
}

TEST_F(ImageReader, ServesTextureSystems) {
  const auto system = OIIO::TextureSystem::create(false);
  OIIO::TextureOpt options;
  options.swrap = OIIO::TextureOpt::WrapPeriodic;
  std::array<float, 3> middle{};
  ASSERT_TRUE(
      system->texture(OIIO::ustring(moon), options, 0.5f, 0.5f, 0, 0, 0, 0, 3, middle.data()))
      << system->geterror();
  const auto texels = texels_of(moon);
  // between the four texels about the middle of the map, by cubic weights of which none is above 1
  const auto around = [&](std::size_t k) {
    std::array<float, 4> four{};
    for (std::size_t i = 0; i < 4; ++i)
      four[i] = texels[3 * ((63 + i / 2) * 256 + 127 + i % 2) + k];
    return four;
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [least, most] = std::ranges::minmax(around(k));
    EXPECT_GT(middle[k], 0.8f * least);
    EXPECT_LT(middle[k], 1.2f * most);
  }
  OIIO::TextureSystem::destroy(system);
}

/// oiiotool itself says "File does not exist" of any name with options that cannot be opened.
TEST_F(ImageReader, SaysWhatIsWrongBehindANameWhereTheHostDoesNot) {
  const auto of_width = run({"oiiotool", "--info", moon + "?texture-width=127"});
  EXPECT_SAYS(of_width.err, "coppermoon: texture width [texels] = 127, allowed even numbers");
  const auto of_name = run({"oiiotool", "--info", moon + "?width=128"});
  const auto said = of_name.err.find("has an option width, allowed at, instant");
  EXPECT_NE(said, std::string::npos) << of_name.err;
  EXPECT_EQ(of_name.err.find("has an option", said + 1), std::string::npos) << "said once";
}

/// OpenImageIO's writers drop attributes that begin with the name of another format.
TEST_F(ImageReader, KeepsTheRecipeInFilesThatHostsWrite) {
  expect_done(run(words_of("oiiotool {} -o copy.exr", moon)));
  const auto copy = OIIO::ImageInput::open(here("copy.exr"));
  ASSERT_TRUE(copy);
  EXPECT_SAYS(copy->spec().get_string_attribute("coppermoon:recipe"), "unshadowed");
  expect_done(coppermoon("bake copy.exr --albedo-map built-in -o again.exr"));
  EXPECT_EQ(texels_of(here("again.exr")), texels_of(moon));
}

TEST_F(ImageReader, ServesMaketx) {
  expect_done(run(words_of("maketx --swrap periodic --twrap clamp {} -o moon.tx", moon)));
  EXPECT_EQ(texels_of(here("moon.tx")), texels_of(moon));
  for (const auto& texture : {moon, here("moon.tx").string()}) {
    const auto input = OIIO::ImageInput::open(texture);
    ASSERT_TRUE(input) << texture;
    EXPECT_EQ(input->spec().get_string_attribute("wrapmodes"), "periodic,clamp") << texture;
  }
}

}  // namespace coppermoon::end_to_end::image_reader_test
