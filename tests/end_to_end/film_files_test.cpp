// SPDX-License-Identifier: MIT
// What is made of a whole film, as far as no frame is rendered for it.
#include <nlohmann/json.hpp>

#include "support/program.h"
#include "texture/read_image.h"

namespace coppermoon::end_to_end::film_files_test {

class FilmFiles : public ProgramTest {
 protected:
  static Words film(const Words& more, const std::string& air = "undated") {
    return words_of(
               "animate 2018-07-27 --from 2018-07-27T18:40:00Z --to 2018-07-27T20:20:00Z --frames "
               "3 "
               "--make textures --albedo-map built-in --texture-width 512 --atmosphere {} -o film",
               air) +
           more;
  }
};

struct Row {
  std::string instant;
  double hours, magnitude, luminance;
};

std::vector<Row> rows_of(const std::string& csv) {
  std::istringstream lines(csv);
  std::vector<Row> rows;
  std::string line, cell;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    Words words;
    while (std::getline(cells, cell, ',')) words.push_back(cell);
    rows.push_back(
        {words.at(1), std::stod(words.at(2)), std::stod(words.at(3)), std::stod(words.at(4))});
  }
  return rows;
}

TEST_F(FilmFiles, CurveSaysWhatTheVerbBrightnessDoes) {
  expect_done(coppermoon(film("--curve film/curve.csv", "standard")));
  const auto rows = rows_of(text_of(here("film/curve.csv")));
  ASSERT_EQ(rows.size(), 3);
  for (const auto& row : rows) {
    const auto outcome = coppermoon(
        words_of("brightness {} --json --albedo-map built-in --texture-width 512", row.instant));
    const auto all = nlohmann::json::parse(outcome.out);
    EXPECT_WITHIN(row.magnitude, all["magnitudes"]["V"].get<double>(), 5e-4,
                  "another simulation, on twice as many rows: 1.2e-4 found over a whole eclipse");
    EXPECT_WITHIN_RELATIVE(row.luminance, all["mean_luminance_cd_m2"].get<double>(), 5e-4,
                           "the same");
  }
  EXPECT_LT(rows[0].magnitude, -10) << "in the penumbra";
  EXPECT_GT(rows[2].magnitude, -2) << "in the umbra";
  EXPECT_GT(rows[0].luminance, 1000 * rows[2].luminance);
}

TEST_F(FilmFiles, CurveHasTheInstantsOfItsRangeAndTheHoursFromGreatest) {
  expect_done(coppermoon(film("--range 3,1 --curve curve.csv")));
  const auto rows = rows_of(text_of(here("curve.csv")));
  ASSERT_EQ(rows.size(), 2);
  EXPECT_EQ(rows[0].instant, "2018-07-27T18:40:00.000Z");
  EXPECT_EQ(rows[1].instant, "2018-07-27T20:20:00.000Z");
  // NASA's catalogue: greatest at 20:22:54 TD, ΔT 69 s, so 20:21:45 UT.
  EXPECT_WITHIN(rows[0].hours, -(1 + 41. / 60 + 45. / 3600), 10. / 3600,
                "contacts agree with published ones to 8 s");
}

TEST_F(FilmFiles, CurveIsDrawnWithTheContactsWithinIt) {
  expect_done(coppermoon(film("--curve curve.svg --curve curve.png")));
  const auto svg = text_of(here("curve.svg"));
  for (const char* word : {"<svg", ">U2<", ">hours from greatest eclipse<", ">V magnitude<"})
    EXPECT_SAYS(svg, word);
  for (const char* beyond : {">P1<", ">U3<", ">U4<"}) EXPECT_SAYS_NOT(svg, beyond);
  EXPECT_TRUE(text_of(here("curve.png")).starts_with("\x89PNG"));
}

TEST_F(FilmFiles, AreToldAsEvents) {
  const auto outcome = coppermoon(film("--json --curve curve.csv"));
  expect_done(outcome);
  EXPECT_SAYS(outcome.out, R"({"event":"file","file":"curve.csv"})");
}

TEST_F(FilmFiles, OfAShardAreRefused) {
  for (const Words& more : {Words("--curve a.csv"), Words("--movie a.mp4"),
                            Words("--composite a.png"), Words("--contact-sheet a.png")}) {
    expect_refused(film("--shard 1/2" + more),
                   more.front() + " needs every frame: run it without --shard after all");
  }
}

TEST_F(FilmFiles, OfOtherEndingsAreRefused) {
  expect_refused(film("--curve a.txt"),
                 "a.txt: a curve ends in .csv (numbers), .png (plot), .svg (plot), .pdf (plot)");
  expect_refused(film("--movie a.avi"), "a.avi: a movie ends in .mp4 or .mov");
  expect_refused(film("--contact-sheet a.jpg"), "a.jpg: a contact sheet ends in .png");
  expect_refused(film("--composite a.exr"), "a.exr: a composite ends in .png");
}

TEST_F(FilmFiles, InFoldersThatAreNotThereAreRefused) {
  expect_refused(film("--curve nowhere/a.csv"), "nowhere: no such directory");
}

TEST_F(FilmFiles, OfFfmpegAreRefusedWhereItIsNot) {
  expect_refused(film("--make pictures --movie a.mp4"),
                 "ffmpeg: not found; install the package ffmpeg", could_not, {.path = "/nowhere"});
}

TEST_F(FilmFiles, MayBeMipmappedTexturesOfAFewMoments) {
  const Words words =
      "animate 2018-07-27 --moments U1,U2+5min,greatest --make tx --atmosphere undated "
      "--texture-width 64 -o film";
  expect_done(coppermoon(words));
  EXPECT_EQ(listing(),
            (std::set<std::string>{
                "here/film", "here/film/eclipse.light", "here/film/moon_lin_rec709.0001.tx",
                "here/film/moon_lin_rec709.0002.tx", "here/film/moon_lin_rec709.0003.tx"}));
  const auto last = here("film/moon_lin_rec709.0003.tx");
  EXPECT_EQ(texture::read_attribute(last, "coppermoon:instant").value_or("").substr(0, 18),
            "2018-07-27T20:21:4")
      << "greatest by NASA's catalogue: 20:21:45";
  EXPECT_EQ(texture::read_attribute(last, "textureformat"), "Plain Texture");
  const auto again = coppermoon(words);
  EXPECT_SAYS(again.out, "0 frames made, 3 kept");
  EXPECT_EQ(coppermoon("animate 2018-07-27 --moments U1 --from U1 -o film").err,
            "coppermoon: moments = U1, allowed without --from and --to\n");
  EXPECT_EQ(
      coppermoon("animate 2018-07-27 --make tx,frames -o other").err,
      "coppermoon: tx are textures without parts and frames, allowed in a film of their own\n");
}

}  // namespace coppermoon::end_to_end::film_files_test
