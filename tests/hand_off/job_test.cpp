// SPDX-License-Identifier: MIT
// A film's job, checked and run by Open Job Description's own program (openjd-cli of PyPI).
#include "support/program.h"

namespace coppermoon::hand_off::job_test {

namespace fs = std::filesystem;

const Words film =
    "animate 2018-07-27 --at -21.1,55.5 --frames 12 --width 120 --height 80 --field 0.9 --make "
    "pictures --albedo-map maps/moon.exr --texture-width 256";

class Job : public ProgramTest {
 protected:
  Outcome openjd(const Words& words, const std::string& program) const {
    return run(words_of("{} run job.yaml -p {} -p Shards=3",
                        COPPERMOON_HAND_OFF_PYTHON "/bin/openjd", "Program=" + program) +
               words);
  }

  auto files(const char* folder) const { return contents(here(folder)); }

  /// A program that is killed once it has made a frame.
  std::string dying() const {
    return script("dying", COPPERMOON_PROGRAM
                  " \"$@\" &\n"
                  "until ls film/frame.*.png >/dev/null 2>&1; do sleep 0.02; done\n"
                  "kill -9 $! && wait $!")
        .string();
  }
};

TEST_F(Job, IsRunByOpenJobDescriptionWithATaskKilledOnTheWay) {
  fs::create_directory(here("maps"));
  expect_done(coppermoon(
      "bake 2018-07-27T20:00Z --albedo-map built-in --texture-width 512 --passes -o passes.exr"));
  expect_done(run("oiiotool passes.exr --subimage albedo -o maps/moon.exr"));
  const Words of_all = "--contact-sheet film/sheet.png --movie film/eclipse.mp4";
  expect_done(coppermoon(film + of_all + "-o film"));
  const auto at_once = files("film");
  EXPECT_EQ(at_once.size(), 12U + 3U) << "frames, light, sheet and movie";
  fs::remove_all(here("film"));

  expect_done(coppermoon(film + of_all + "-o film --job job.yaml"));
  const auto checked = run({COPPERMOON_HAND_OFF_PYTHON "/bin/openjd", "check", "job.yaml"});
  EXPECT_EQ(checked.status, 0) << checked.out << checked.err;
  const Words one_task = "--step frames -tp Shard=2";
  EXPECT_NE(openjd(one_task, dying()).status, 0) << "its program was killed";
  const auto left = files("film").size();
  EXPECT_GE(left, 1U + 1U) << "the light, and a frame";
  EXPECT_LT(left, 1U + 4U) << "killed on the way";
  auto outcome = openjd(one_task, COPPERMOON_PROGRAM);
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_EQ(files("film").size(), 1U + 4U);
  outcome = openjd("--step film --run-dependencies", COPPERMOON_PROGRAM);
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_TRUE(files("film") == at_once) << "the bytes of the direct run";
}

}  // namespace coppermoon::hand_off::job_test
