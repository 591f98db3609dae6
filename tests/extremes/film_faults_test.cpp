// SPDX-License-Identifier: MIT
// A film that is killed at random moments: what it told of is there, nothing else is, and the next run completes it with
// the bytes of an undisturbed one.
#include <fmt/format.h>
#include <cstdio>

#include "extremes/faults.h"
#include "extremes/tried.h"
#include "support/testing.h"

namespace coppermoon::extremes::film_faults_test {

const Words film =
    "animate 2018-07-27 --from U1 --to U2 --frames 8 --at -21,55 --field 0.9 --texture-width 256 "
    "--albedo-map built-in --width 72 --height 48 --make frames,pictures -o film";

class FilmFaults : public Faults {
 protected:
  void expect_all_there(const std::string& out) const override {
    std::istringstream lines(out);
    for (std::string line; std::getline(lines, line);) {
      unsigned frame = 0;
      if (std::sscanf(line.c_str(), "%*u of %*u: frame %u", &frame) != 1) continue;
      EXPECT_TRUE(fs::exists(here(fmt::format("film/frame.{:04}.png", frame)))) << line;
      EXPECT_TRUE(fs::exists(here(fmt::format("film/frame_lin_rec709.{:04}.exr", frame)))) << line;
    }
  }
};

TEST_F(FilmFaults, AnimateKilledLosesNoFrameThatItToldOf) {
  constexpr int times = 50;
  expect_whole_wherever_killed(film, times, [&] { fs::remove_all(here("film")); });
  tried(fmt::format("`animate`, kill -9 at {} random moments, each resumed", times),
        "every frame told of, whole; the next run's bytes; no stray files");
}

TEST_F(FilmFaults, TwoRunsIntoOneFilmMakeItOnce) {
  done(film);
  const auto whole = files();
  fs::remove_all(here("film"));
  fs::create_directory(here("film"));
  auto whole_command = film;
  whole_command.insert(whole_command.begin(), COPPERMOON_PROGRAM);
  const auto first = begun(whole_command), second = begun(whole_command);
  for (const auto run : {first, second}) EXPECT_EQ(ended(run).status, 0);
  EXPECT_TRUE(files() == whole);
  tried("two `animate` into one folder at once", "the bytes of one");
}

TEST_F(FilmFaults, AFullDiskIsSaidAndTheFilmGoesOn) {
  const auto outcome = coppermoon(film, {.file_limit = 5000});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
  EXPECT_EQ(left_behind(), std::set<std::string>{});
  done(film);
  tried("`animate`, the disk full", "one line: " + outcome.err.substr(0, outcome.err.find('\n')));
}

TEST_F(FilmFaults, PovrayKilledIsSaidAndTheFilmGoesOn) {
  const auto outcome = coppermoon(film, with_povray("kill -9 $$\n"));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
  EXPECT_EQ(left_behind(), std::set<std::string>{});
  done(film);
  tried("`animate`, POV-Ray killed", "one line: " + outcome.err.substr(0, outcome.err.find('\n')));
}

}  // namespace coppermoon::extremes::film_faults_test
