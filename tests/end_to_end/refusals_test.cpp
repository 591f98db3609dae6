// SPDX-License-Identifier: MIT
// What would hang, wrap around or be said in words that do not help, were it not refused at once.
#include <sys/stat.h>

#include "end_to_end/program.h"
#include "texture/write_image.h"

namespace coppermoon::end_to_end {
namespace {

constexpr const char* eclipsed = "2008-02-21T03:26:05Z";

class Refusals : public ProgramTest {
 protected:
  void expect_refused(const Words& words, int status, const std::string& why) const {
    Words timed{"timeout", "20", COPPERMOON_PROGRAM};
    timed.insert(timed.end(), words.begin(), words.end());
    const auto outcome = run(timed);
    EXPECT_EQ(outcome.status, status);
    EXPECT_EQ(outcome.err, "coppermoon: " + why + "\n");
  }
};

constexpr int could_not = 1, wrong_usage = 2;

TEST_F(Refusals, APipeInThePlaceOfAFileIsRefused) {
  ASSERT_EQ(::mkfifo(here("pipe").c_str(), 0666), 0);
  texture::write_exr(here("a.exr"), texture::Image(4, 2, {"R", "G", "B"}), {});
  for (const auto& words :
       std::vector<Words>{{"fit", "--magnitudes", "pipe"},
                          {"fit", "pipe", "--instants", eclipsed},
                          {"merge", "pipe", "-o", "b.exr"},
                          {"compare", "pipe", "a.exr"},
                          {"develop", "pipe", "-o", "a.png"},
                          {"develop", "a.exr", "--config", "pipe", "-o", "a.png"},
                          {"bake", eclipsed, "--recipe", "pipe", "-o", "b.exr"},
                          {"bake", eclipsed, "--albedo-map", "pipe", "-o", "b.exr"}})
    expect_refused(words, could_not, "pipe: cannot be read: it is no regular file");
  ASSERT_EQ(::mkfifo(here("pipe.exr").c_str(), 0666), 0);
  expect_refused({"bake", "pipe.exr", "-o", "b.exr"}, could_not,
                 "pipe.exr: cannot be read: it is no regular file");
}

TEST_F(Refusals, WholeNumbersThatAreNoneOrTooLargeAreNamed) {
  const auto bake = [&](const char* flag, const char* value, const std::string& why) {
    expect_refused({"bake", eclipsed, flag, value, "-o", "a.exr"}, wrong_usage, why);
  };
  bake("--seed", "18446744073709551616",
       "--seed = 18446744073709551616, allowed 0 to 18446744073709551615");
  bake("--seed", "-1", "--seed = -1, allowed whole numbers, 0 or more");
  bake("--danjon", "1.5", "--danjon = 1.5, allowed whole numbers");
  bake("--danjon", "3000000000", "--danjon = 3000000000, allowed -2147483648 to 2147483647");
}

TEST_F(Refusals, AnOutputThatAWordDoesNotHaveIsAnsweredWithThoseItHas) {
  expect_refused({"sky", eclipsed, "-o", "u.csv"}, wrong_usage,
                 "-o: unknown option of sky; it prints its results");
}

TEST_F(Refusals, AFlagWithNothingBehindItsSignTakesNotTheNextWord) {
  expect_refused({"animate", "2018-07-27", "--range=", "-o", "film"}, wrong_usage,
                 "--range: a value is missing behind the =");
}

TEST_F(Refusals, MoreRegionsThanCanBeComputedAreRefusedAtOnce) {
  Words bake{"bake", eclipsed, "-o", "a.exr"};
  for (int i = 0; i < 300; ++i) {
    bake.push_back("--region");
    bake.push_back("from-latitude=-90,to-latitude=0,ozone-du=" + std::to_string(200 + i));
  }
  expect_refused(bake, could_not,
                 "regions = 300, allowed up to 72: each has air of its own to compute");
}

/// A shell of few descriptors cannot redirect: the folder's remover needs none.
TEST_F(Refusals, FewFileDescriptorsDoNotTakeTheTemporaryFolderAway) {
  for (const char* most : {"7", "8", "9", "10"}) {
    const auto outcome =
        run({"sh", "-c", "exec 3>&- 4>&-; ulimit -n $0; exec \"$@\"", most, COPPERMOON_PROGRAM,
             "still", eclipsed, "--unshadowed", "--texture-width", "16", "--width", "16",
             "--height", "16", "--albedo-map", "built-in", "-o", "a.png"});
    EXPECT_EQ(outcome.err.find("No such file"), std::string::npos) << outcome.err;
  }
}

TEST_F(Refusals, AMissingFolderForTemporaryFilesIsNamed) {
  const auto outcome =
      run({"env", "TMPDIR=/no/such", COPPERMOON_PROGRAM, "still", eclipsed, "-o", "a.png"});
  EXPECT_EQ(outcome.status, could_not);
  EXPECT_EQ(outcome.err,
            "coppermoon: TMPDIR = /no/such: no such directory, allowed one that is there\n");
  const auto film =
      run({"env", "TMPDIR=/no/such", COPPERMOON_PROGRAM, "animate", "2018-07-27", "-o", "film"});
  EXPECT_EQ(film.err, outcome.err);
  EXPECT_FALSE(std::filesystem::exists(here("film"))) << "said before any work";
}

}  // namespace
}  // namespace coppermoon::end_to_end
