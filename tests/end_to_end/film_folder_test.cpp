// SPDX-License-Identifier: MIT
// A folder holds one film: nothing of another is overwritten or taken for its own.
#include <sys/stat.h>

#include "files/lock.h"
#include "support/program.h"
#include "support/testing.h"
#include "texture/image.h"
#include "texture/read_image.h"
#include "texture/write_image.h"

namespace coppermoon::end_to_end::film_folder_test {

namespace fs = std::filesystem;

class FilmFolder : public ProgramTest {
 protected:
  FilmFolder() { write_map(0.5F); }

  Words film(const Words& more = {}, const char* folder = "film") const {
    return words_of(
               "animate 2018-07-27 -o {} --from U1 --to U2 --make frames,pictures --width 24 "
               "--height 16 --field 0.9 --quality draft --albedo-map map.png --texture-width 64 "
               "--atmosphere undated",
               folder) +
           more;
  }

  auto files(const char* folder = "film") const { return contents(here(folder)); }

  void write_map(float grey) const {
    texture::Image map(16, 8, {"Y"});
    for (std::size_t i = 0; i < map.values.size(); ++i) map.values[i] = i % 2 ? grey : 0.2F;
    texture::write_png(here("map.png"), map, 8);
  }

  /// One line that says why, and nothing changed.
  void expect_refused(const Words& words, const std::string& why) const {
    expect_refusal(words, "film: holds " + why + ", allowed another folder, or --replace");
  }
};

TEST_F(FilmFolder, OfAnotherExposureIsRefusedOrDevelopedAgain) {
  expect_done(coppermoon(film("--frames 2")));
  const auto another = film("--frames 2 --iso 100 --time 2");
  expect_refused(another,
                 "a film made with iso = 800, asked 100; time = 'composite', asked '2' "
                 "(frame.0001.png and 3 more)");
  const Surroundings without_povray{.path = "/nowhere"};
  const auto replaced = coppermoon(another + Words{"--replace"}, without_povray);
  expect_done(replaced);
  EXPECT_SAYS(replaced.out, "0 frames made, 2 developed again from kept linear frames, 0 kept");
  expect_done(coppermoon(film("--frames 2 --iso 100 --time 2", "fresh")));
  EXPECT_TRUE(files() == files("fresh")) << "what a film made at once is";
}

using FilmFolderThoroughly = FilmFolder;

TEST_F(FilmFolderThoroughly, OfAnotherSceneIsRefusedOrMadeAnew) {
  expect_done(coppermoon(film("--frames 3")));
  expect_refused(film("--frames 2"),
                 "a film made with frames = 3, asked 2 (frame.0001.png and 5 more)");
  expect_refused(film("--frames 3 --field 1"),
                 "a film made with field = 0.9, asked 1 (frame.0001.png and 5 more)");
  expect_refused(film("--frames 3 --region dust-extinction=1e-5,from-latitude=-90,to-latitude=0"),
                 "a film made with other contents of regions (frame.0001.png and 5 more)");
  expect_done(coppermoon(film("--frames 2 --replace")));
  expect_done(coppermoon(film("--frames 2", "fresh")));
  EXPECT_TRUE(files() == files("fresh")) << "the third frame is gone: it is of no film here";
}

TEST_F(FilmFolder, IsNotSharedWithAnotherFilmThatIsBeingMade) {
  fs::create_directory(here("film"));
  const auto another = files::claim_folder(here("film"), 1);
  const auto outcome = coppermoon(film("--frames 2 --replace"));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err,
            "coppermoon: film: another film is being made in it, allowed another folder\n");
  EXPECT_TRUE(files().empty());
}

TEST_F(FilmFolder, MayHaveMoreMadeOfItsFilm) {
  expect_done(coppermoon(film("--frames 2 --make pictures")));
  expect_done(coppermoon(film("--frames 2 --make textures,frames")));
  EXPECT_EQ(files().size(), 7U);
}

TEST_F(FilmFolderThoroughly, OfAMapThatChangedIsRefused) {
  expect_done(coppermoon(film("--frames 2")));
  write_map(0.6F);
  fs::remove(here("film/frame.0002.png"));
  expect_refused(film("--frames 2"),
                 "a film made with other contents of albedo-map (frame.0001.png and 2 more)");
}

TEST_F(FilmFolderThoroughly, OfAConfigurationThatChangedIsRefused) {
  const auto config = text_of(COPPERMOON_TEST_DATA "/../colour/config.ocio");
  file("config.ocio", config);
  const auto words = film("--frames 2 --config config.ocio --display 'Display P3'");
  expect_done(coppermoon(words));
  file("config.ocio", "# a comment changes no colour\n" + config);
  expect_done(coppermoon(words));
  auto other = config;
  const std::string gamma = "gamma: [2.4, 2.4, 2.4, 1]";
  ASSERT_NE(other.find(gamma), std::string::npos);
  for (auto at = other.find(gamma); at != other.npos; at = other.find(gamma, at + 1))
    other.replace(at, gamma.size(), "gamma: [2.3, 2.4, 2.4, 1]");
  file("config.ocio", other);
  expect_refused(words, "a film made with other contents of view (frame.0001.png and 1 more)");
}

TEST_F(FilmFolder, OfAnotherVersionIsRefused) {
  expect_done(coppermoon(film("--frames 1")));
  auto image = texture::read_image(here("film/frame_lin_rec709.0001.exr"));
  texture::write_exr(here("film/frame_lin_rec709.0001.exr"), image,
                     {{"coppermoon:recipe", std::string("iso = 800\n")},
                      {"coppermoon:version", std::string("0.0.1")}});
  const auto outcome = coppermoon(film("--frames 1"));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_SAYS(outcome.err, "version = 0.0.1, asked");
}

TEST_F(FilmFolder, GoesOnBesideTheMapItReads) {
  for (const char* folder : {"film", "film/", "./film"}) {
    expect_done(coppermoon(film("--frames 1", folder)));
    const auto outcome = coppermoon(film("--frames 1 --json", folder));
    EXPECT_SAYS(outcome.out, "\"made\":0,\"kept\":1");
  }
}

TEST_F(FilmFolder, KeepsPicturesOfSomebodyElse) {
  fs::create_directory(here("film"));
  texture::write_png(here("film/frame.0001.png"), texture::Image(2, 2, {"Y"}), 8);
  expect_refused(film("--frames 1"), "what is no film of coppermoon's (frame.0001.png)");
}

TEST_F(FilmFolder, KeepsTheLightOfAnotherFilm) {
  expect_done(coppermoon(film("--frames 2 --make light")));
  expect_refused(film("--frames 2 --make light --ozone-du 200"),
                 "the light of a film made with ozone-du = none, asked 200 (eclipse.light)");
  expect_done(coppermoon(film("--frames 2 --make light --iso 100")));
  expect_done(coppermoon(film("--frames 2 --make light --ozone-du 200 --replace")));
}

TEST_F(FilmFolder, WithAFlippedBitInAFrameHasItMadeAgain) {
  expect_done(coppermoon(film("--frames 1")));
  const auto whole = files();
  const auto frame = here("film/frame_lin_rec709.0001.exr");
  for (const std::size_t from_end : {1, 100, 300}) {
    auto bytes = text_of(frame);
    auto& byte = bytes[bytes.size() - from_end];
    byte = static_cast<char>(byte ^ 4);
    std::ofstream(frame, std::ios::binary) << bytes;
    expect_done(coppermoon(film("--frames 1")));
    EXPECT_TRUE(files() == whole);
  }
}

TEST_F(FilmFolder, TakesRegularFilesAlone) {
  fs::create_directories(here("film/eclipse.light"));
  auto outcome = coppermoon(film("--frames 1"));
  EXPECT_EQ(outcome.err, "coppermoon: film/eclipse.light: cannot be read: it is a directory\n");
  fs::remove(here("film/eclipse.light"));
  ASSERT_EQ(::mkfifo(here("film/eclipse.light").c_str(), 0666), 0);
  outcome = coppermoon(film("--frames 1"));
  EXPECT_EQ(outcome.err, "coppermoon: film/eclipse.light: cannot be read: it is no regular file\n");
  fs::remove(here("film/eclipse.light"));
  ASSERT_EQ(::mkfifo(here("film/a.sums").c_str(), 0666), 0);
  outcome = coppermoon(film("--frames 1 --photons 1000"));
  EXPECT_EQ(outcome.err, "coppermoon: film/a.sums: cannot be read: it is no regular file\n");
}

TEST_F(FilmFolder, HasTheCurveOfItsLightAlone) {
  expect_done(coppermoon(film("--frames 3 --make light --curve curve.csv")));
  const auto curve = text_of(here("curve.csv"));
  EXPECT_EQ(std::ranges::count(curve, '\n'), 4) << curve;
}

/// Standard descriptors that are closed are no file's numbers.
TEST_F(FilmFolderThoroughly, IsMadeWithStandardDescriptorsClosed) {
  for (const char* closed : {"<&- >&- 2>&-", ">&-", ">/dev/full"}) {
    std::string line = COPPERMOON_PROGRAM;
    for (const auto& word : film("--frames 2 --movie film.mp4 --json")) line += " " + word;
    const auto outcome = run({"sh", "-c", line + " " + closed});
    EXPECT_EQ(outcome.status, 1) << "standard output cannot be written";
    EXPECT_GT(text_of(here("film.mp4")).size(), 500U) << closed;
    EXPECT_EQ(files().size(), 5U);
    fs::remove(here("film.mp4"));
  }
}

}  // namespace coppermoon::end_to_end::film_folder_test
