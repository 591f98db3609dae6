// SPDX-License-Identifier: MIT
// What would hang, wrap around or be said in words that do not help, were it not refused at once.
#include <sys/stat.h>

#include "support/program.h"
#include "texture/write_image.h"

namespace coppermoon::end_to_end::refusals_test {

constexpr const char* eclipsed = "2008-02-21T03:26:05Z";

class Refusals : public ProgramTest {
 protected:
};

const Surroundings soon{.seconds_limit = 20};

TEST_F(Refusals, APipeInThePlaceOfAFileIsRefused) {
  ASSERT_EQ(::mkfifo(here("pipe").c_str(), 0666), 0);
  texture::write_exr(here("a.exr"), texture::Image(4, 2, {"R", "G", "B"}), {});
  for (const auto& words :
       std::vector<Words>{{"fit", "--magnitudes", "pipe"},
                          words_of("fit pipe --instants {}", eclipsed),
                          "merge pipe -o b.exr",
                          {"compare", "pipe", "a.exr"},
                          "develop pipe -o a.png",
                          "develop a.exr --config pipe -o a.png",
                          words_of("bake {} --recipe pipe -o b.exr", eclipsed),
                          words_of("bake {} --albedo-map pipe -o b.exr", eclipsed)})
    expect_refusal(words, "pipe: cannot be read: it is no regular file", could_not, soon);
  ASSERT_EQ(::mkfifo(here("pipe.exr").c_str(), 0666), 0);
  expect_refusal("bake pipe.exr -o b.exr", "pipe.exr: cannot be read: it is no regular file",
                 could_not, soon);
}

TEST_F(Refusals, WholeNumbersThatAreNoneOrTooLargeAreNamed) {
  const auto bake = [&](const char* flag, const char* value, const std::string& why) {
    expect_refusal(words_of("bake {} {} {} -o a.exr", eclipsed, flag, value), why, wrong_usage,
                   soon);
  };
  bake("--seed", "18446744073709551616",
       "--seed = 18446744073709551616, allowed 0 to 18446744073709551615");
  bake("--seed", "-1", "--seed = -1, allowed whole numbers, 0 or more");
  bake("--danjon", "1.5", "--danjon = 1.5, allowed whole numbers");
  bake("--danjon", "3000000000", "--danjon = 3000000000, allowed -2147483648 to 2147483647");
}

TEST_F(Refusals, AnOutputThatAWordDoesNotHaveIsAnsweredWithThoseItHas) {
  expect_refusal(words_of("sky {} -o u.csv", eclipsed),
                 "-o: unknown option of sky; it prints its results", wrong_usage, soon);
}

TEST_F(Refusals, AFlagWithNothingBehindItsSignTakesNotTheNextWord) {
  expect_refusal("animate 2018-07-27 --range= -o film",
                 "--range: a value is missing behind the =", wrong_usage, soon);
}

TEST_F(Refusals, MoreRegionsThanCanBeComputedAreRefusedAtOnce) {
  auto bake = words_of("bake {} -o a.exr", eclipsed);
  for (int i = 0; i < 300; ++i) {
    bake.push_back("--region");
    bake.push_back("from-latitude=-90,to-latitude=0,ozone-du=" + std::to_string(200 + i));
  }
  expect_refusal(bake, "regions = 300, allowed up to 72: each has air of its own to compute",
                 could_not, soon);
}

/// A shell of few descriptors cannot redirect: the folder's remover needs none.
TEST_F(Refusals, FewFileDescriptorsDoNotTakeTheTemporaryFolderAway) {
  for (const char* most : {"7", "8", "9", "10"}) {
    const auto outcome =
        run({"sh", "-c", "exec 3>&- 4>&-; ulimit -n $0; exec \"$@\"", most, COPPERMOON_PROGRAM,
             "still", eclipsed, "--unshadowed", "--texture-width", "16", "--width", "16",
             "--height", "16", "--albedo-map", "built-in", "-o", "a.png"});
    EXPECT_SAYS_NOT(outcome.err, "No such file");
  }
}

TEST_F(Refusals, AMissingFolderForTemporaryFilesIsNamed) {
  const auto outcome =
      run(words_of("env TMPDIR=/no/such {} still {} -o a.png", COPPERMOON_PROGRAM, eclipsed));
  EXPECT_EQ(outcome.status, could_not);
  EXPECT_EQ(outcome.err,
            "coppermoon: TMPDIR = /no/such: no such directory, allowed one that is there\n");
  const auto film =
      run(words_of("env TMPDIR=/no/such {} animate 2018-07-27 -o film", COPPERMOON_PROGRAM));
  EXPECT_EQ(film.err, outcome.err);
  EXPECT_FALSE(std::filesystem::exists(here("film"))) << "said before any work";
}

}  // namespace coppermoon::end_to_end::refusals_test
