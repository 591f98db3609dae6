// SPDX-License-Identifier: MIT
// Command lines by which a file would be lost to another: refused in one line, before any work, and every byte is kept.
#include <fmt/format.h>
#include <sys/stat.h>

#include "support/program.h"
#include "texture/write_image.h"

namespace coppermoon::end_to_end::lost_files_test {

namespace fs = std::filesystem;

constexpr const char* eclipse_of_2008 = "2008-02-21T03:26:05Z";

class LostFiles : public ProgramTest {
 protected:
  void picture(const std::string& name) const {
    texture::Image image(8, 4, {"R", "G", "B"});
    std::ranges::fill(image.values, 0.5F);
    if (name.ends_with(".exr"))
      texture::write_exr(here(name), image, {});
    else
      texture::write_png(here(name), image, 8);
  }

  static Words bake(const Words& more) {
    return words_of("bake {} --texture-width 16", eclipse_of_2008) + more;
  }
};

TEST_F(LostFiles, ThatAreReadAreNotWritten) {
  picture("map.png");
  picture("frame.exr");
  picture("photo.png");
  expect_refused(bake("--albedo-map map.png -o map.png"),
                 "map.png: --output would overwrite the file that --albedo-map reads");
  expect_refused("compare photo.png frame.exr -o photo.png",
                 "photo.png: --output would overwrite the file that --photo reads");
  expect_refused("merge frame.exr photo.png -o photo.png",
                 "--output would overwrite the file that --photographs reads");
  expect_refused("develop frame.exr -o new.png --camera paper --photograph frame.exr",
                 "--photograph would overwrite the file that --frame reads");
}

TEST_F(LostFiles, ThatAreReadAreNotWrittenThroughLinksOrOtherNames) {
  picture("map.png");
  fs::create_directory(here("folder"));
  fs::create_symlink("map.png", here("soft.png"));
  fs::create_hard_link(here("map.png"), here("hard.png"));
  for (const char* same : {"soft.png", "hard.png", "./map.png", "folder/../map.png"})
    expect_refused(bake(words_of("--albedo-map map.png -o {}", same)), "would overwrite the file");
}

TEST_F(LostFiles, OfTheRecipeIsNotWritten) {
  file("my.toml", "texture-width = 16\nalbedo-map = \"built-in\"\nsolver = \"photons\"\n");
  expect_refused(words_of("bake {} --recipe my.toml -o moon.exr --keep my.toml", eclipse_of_2008),
                 "my.toml: --keep would overwrite the file that --recipe reads");
}

TEST_F(LostFiles, OfTwoOutputsAreNotOne) {
  expect_refused(bake("--albedo-map built-in --solver photons --keep t.exr -o t.exr"),
                 "write one file, allowed two");
  expect_refused(bake("--albedo-map built-in -o a.exr -o ./a.exr"),
                 "--output and --output write one file");
  const Words film =
      "animate 2018-07-27 --frames 3 --width 16 --height 12 --albedo-map built-in -o film";
  const auto with = [&](Words words, const Words& more) {
    words += more;
    return words;
  };
  expect_refused(with(film, "--contact-sheet s.png --curve s.png"), "write one file");
  expect_refused(with(film, "--contact-sheet film/frame.0002.png"),
                 "film/frame.0002.png: is the name of a frame, allowed another");
}

TEST_F(LostFiles, AreNoFoldersOfTheirNames) {
  picture("a.exr");
  picture("b.exr");
  expect_refused("animate 2018-07-27 -o film.mp4",
                 "film.mp4: --output names a folder, allowed a name without .mp4");
  expect_refused("bake 2018-07-27 --cache tex.tx",
                 "tex.tx: --cache names a folder, allowed a name without .tx");
  expect_refused("develop a.exr b.exr -o c.avif", "c.avif: 2 frames are developed");
  EXPECT_EQ(listing().size(), 2U);
}

TEST_F(LostFiles, InAFilmsFolderAreNotItsMap) {
  fs::create_directory(here("film"));
  picture("film/frame.0001.png");
  expect_refused("animate 2018-07-27 --frames 3 --albedo-map film/frame.0001.png -o film",
                 "--albedo-map reads a file of the folder that --output writes");
}

TEST_F(LostFiles, AreNamedByNoRecipe) {
  fs::create_directory(here("v"));
  file("v/victim", "precious");
  for (const auto& [key, verb] :
       std::map<std::string, Words>{{"output", bake("-o mine.exr")},
                                    {"keep", bake("-o mine.exr")},
                                    {"frame", words_of("still {} -o mine.png", eclipse_of_2008)},
                                    {"raw", words_of("still {} -o mine.png", eclipse_of_2008)},
                                    {"curve", "animate 2018-07-27 -o film"}}) {
    file("theirs.toml", fmt::format("{} = \"v/victim\"\n", key));
    auto words = verb;
    words += "--recipe theirs.toml";
    expect_refused(
        words,
        fmt::format("theirs.toml:1: {}: where files go is said on the command line alone", key),
        wrong_usage);
  }
}

TEST_F(LostFiles, AreNotThoseWrittenAgain) {
  picture("map.png");
  for (int times = 0; times < 2; ++times)
    expect_done(coppermoon(bake("--albedo-map map.png -o moon.exr")));
}

}  // namespace coppermoon::end_to_end::lost_files_test
