// SPDX-License-Identifier: MIT
// What goes wrong around the program: after each fault no partial file under its final name, one clear line from
// whoever is left to say it, and a second run that completes with the bytes of an undisturbed one.
#include <fmt/format.h>

#include <algorithm>

#include "extremes/faults.h"
#include "extremes/tried.h"

namespace coppermoon::extremes::faults_test {

#ifdef __SANITIZE_ADDRESS__
constexpr bool address_sanitizer = true;
#else
constexpr bool address_sanitizer = false;
#endif

// in the air that is computed soonest: what is killed is the writing of files
const Words moon = "2008-02-21T03:26:05Z --atmosphere undated --albedo-map built-in";
const Words bake = Words{"bake"} + moon + "--texture-width 512 -o moon.exr";
const Words frame = "--texture-width 256 --width 96 --height 72";
const Words still = Words{"still"} + moon + frame + "-o moon.png";
const Words scene = Words{"scene"} + moon + frame + "-o eclipse";

std::string said(const Outcome& outcome) { return outcome.err.substr(0, outcome.err.find('\n')); }

TEST_F(Faults, BakeKilledLeavesNothingOrAll) {
  const int times = moments(25);
  expect_whole_wherever_killed(bake, times, [&] { fs::remove(here("moon.exr")); });
  tried(fmt::format("`bake`, kill -9 at {} random moments", times),
        "the whole file or none; the next run's bytes");
}

using FaultsThoroughly = Faults;

TEST_F(FaultsThoroughly, BakeKilledOverAnOldFileLeavesTheOldOrTheNew) {
  const int times = moments(15);
  file("moon.exr", "old");
  expect_whole_wherever_killed(bake, times, [&] { file("moon.exr", "old"); });
  tried(fmt::format("`bake` over an old file, kill -9 at {} random moments", times),
        "the old file or the new");
}

TEST_F(Faults, SceneKilledLeavesWholeFiles) {
  const int times = moments(15);
  expect_whole_wherever_killed(scene, times, [&] { fs::remove_all(here("eclipse")); });
  tried(fmt::format("`scene`, kill -9 at {} random moments", times),
        "each file whole; the next run's bytes");
}

TEST_F(FaultsThoroughly, PhotonsKilledLeaveWholeSums) {
  const int times = moments(15);
  auto photons = bake;
  photons += "--solver photons --photons 3e4 --smoothing-km 300 --keep sums.json";
  expect_whole_wherever_killed(photons, times, [&] {
    fs::remove(here("moon.exr"));
    fs::remove(here("sums.json"));
  });
  tried(fmt::format("`bake --keep`, kill -9 at {} random moments", times),
        "texture and sums each whole or absent");
}

TEST_F(FaultsThoroughly, StillKilledTakesPovrayAndItsFolderAlong) {
  const int times = moments(15);
  expect_whole_wherever_killed(still, times, [&] { fs::remove(here("moon.png")); });
  tried(fmt::format("`still`, kill -9 at {} random moments", times),
        "the whole picture or none; POV-Ray and the temporary folder gone");
}

TEST_F(Faults, StillInterruptedLeavesNothing) {
  const auto around = with_povray("touch '" + here("rendering").string() + "'\nexec sleep 600\n");
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    auto words = still;
    words = Words{COPPERMOON_PROGRAM} + words;
    const pid_t child = begun(words, around);
    ASSERT_TRUE(appears(here("rendering"))) << signal;
    ::kill(child, signal);
    EXPECT_EQ(ended(child).status, 128 + signal);
    EXPECT_EQ(left_behind(), std::set<std::string>{}) << signal;
    EXPECT_FALSE(fs::exists(here("moon.png"))) << signal;
    fs::remove(here("rendering"));
  }
  tried("`still`, interrupted, terminated, its terminal closed", "nothing is left");
}

TEST_F(Faults, PovrayKilledIsSaid) {
  const auto around = with_povray("/usr/bin/povray \"$@\" & sleep 0.1; kill -9 $!; kill -9 $$\n");
  const auto outcome = coppermoon(still, around);
  expect_one_line(outcome, "POV-Ray killed");
  EXPECT_NE(outcome.err.find("signal 9"), std::string::npos) << outcome.err;
  EXPECT_FALSE(fs::exists(here("moon.png")));
  EXPECT_EQ(left_behind(), std::set<std::string>{});
  refused("`still`, POV-Ray killed", said(outcome));
}

TEST_F(Faults, AFullDiskKeepsTheOldFileWhereverItFills) {
  done(bake);
  const auto size = fs::file_size(here("moon.exr"));
  file("moon.exr", "old");
  Outcome outcome;
  for (const double part : {0.01, 0.03, 0.1, 0.5, 0.9, 0.999}) {
    const auto limit = static_cast<rlim_t>(part * static_cast<double>(size));
    outcome = coppermoon(bake, {.file_limit = limit});
    expect_one_line(outcome, fmt::format("full after {} bytes", limit));
    EXPECT_EQ(text_of(here("moon.exr")), "old") << limit;
    EXPECT_EQ(listing(), std::set<std::string>{"here/moon.exr"}) << limit;
  }
  refused("`bake`, the disk full after 1 to 99.9 % of the file", said(outcome));
}

TEST_F(Faults, AFullDiskEndsAStillInOneLine) {
  Outcome outcome;
  for (const rlim_t limit : {300, 1000, 3000, 30000}) {
    outcome = coppermoon(still, {.file_limit = limit});
    expect_one_line(outcome, fmt::format("full after {} bytes", limit));
    EXPECT_EQ(files().size(), 0U) << limit;
    EXPECT_EQ(left_behind(), std::set<std::string>{}) << limit;
  }
  refused("`still`, the disk full after 300 to 30 000 bytes", said(outcome));
}

TEST_F(Faults, FullStandardOutputsAreNoCrash) {
  const auto shell = [&](const std::string& redirected) {
    return run({"sh", "-c", fmt::format("'{}' sky {}", COPPERMOON_PROGRAM, redirected)});
  };
  const auto outcome = shell("2008-02-21T03:26:05Z > /dev/full");
  expect_one_line(outcome, "stdout full");
  EXPECT_EQ(shell("2008-02-99 2> /dev/full").status, 1);
  const auto heard = shell("'2008-02-21 U2'");
  EXPECT_FALSE(heard.err.empty()) << "the moment is said beside the result";
  for (const char* unheard : {"2> /dev/full", "2>&-"}) {
    const auto result = shell(fmt::format("'2008-02-21 U2' {}", unheard));
    EXPECT_EQ(result.status, 0) << unheard;
    EXPECT_EQ(result.out, heard.out) << unheard;
  }
  refused("`sky`, the disk of its standard output full", said(outcome));
}

TEST_F(Faults, AReadOnlyPlaceIsSaid) {
  auto words = bake;
  words.back() = "/proc/moon.exr";
  const auto outcome = coppermoon(words);
  expect_one_line(outcome, "/proc");
  refused("`bake` to a file system that takes no files", said(outcome));
}

TEST_F(Faults, TooLittleMemoryIsSaid) {
  if (address_sanitizer) GTEST_SKIP() << "AddressSanitizer takes 20 TB of addresses for itself";
  int done_at_all = 0, said_at_all = 0;
  std::string message;
  const bool all = support::thorough();
  for (rlim_t megabytes = all ? 150 : 400; megabytes <= (all ? 900 : 700); megabytes += 25) {
    const Surroundings little{.memory_limit = megabytes << 20U};
    if (coppermoon({"--version"}, little).status != 0) continue;  // not even its libraries begin
    const auto outcome = coppermoon(bake, little);
    if (outcome.status == 0) {
      ++done_at_all;
      EXPECT_GT(fs::file_size(here("moon.exr")), 1000U);
    } else {
      ++said_at_all;
      expect_one_line(outcome, fmt::format("{} MB", megabytes));
      if (message.empty()) message = said(outcome);
      EXPECT_FALSE(fs::exists(here("moon.exr"))) << megabytes << " MB";
    }
    fs::remove(here("moon.exr"));
  }
  EXPECT_GT(done_at_all, 0);
  EXPECT_GT(said_at_all, 0);
  refused("`bake` with less memory than it takes", message);
}

TEST_F(Faults, ASpectrumOfFourHundredBandsTakesLittleMemory) {
  if (address_sanitizer) GTEST_SKIP() << "AddressSanitizer has memory of its own for all memory";
  auto words = bake;
  words[1] = "2021-11-19T09:03:50Z";  // an umbra's rim, where black air asks for nodes 1 km apart
  words = words +
          "--texture-width 64 --spectral 1 --tolerance 1.35% --danjon 0 "
          "--stratospheric-aerosol extreme --cloud-cover 0.2";
  const auto outcome = coppermoon(words);
  expect_done(outcome);
  EXPECT_LT(outcome.most_memory_mb, 400)
      << "the colours alone take 160, light at 20 wavelengths 30 more; 2200 were it in 400 bands";
  tried("`bake --spectral 1` of the darkest air", "memory, in MB", 400, outcome.most_memory_mb);
}

TEST_F(FaultsThoroughly, TwoRunsIntoOneFileLeaveOneOfThem) {
  auto other = bake;
  other += "--ozone-du 100";
  done(other);
  const auto second = text_of(here("moon.exr"));
  done(bake);
  const auto first = text_of(here("moon.exr"));
  ASSERT_TRUE(first != second);
  for (int i = 0; i < 5; ++i) {
    auto words = bake;
    words = Words{COPPERMOON_PROGRAM} + words;
    const pid_t one = begun(words);
    coppermoon(other);
    ended(one);
    const auto left = text_of(here("moon.exr"));
    EXPECT_TRUE(left == first || left == second);
    EXPECT_EQ(listing(), std::set<std::string>{"here/moon.exr"});
  }
  tried("two bakes into one file at once", "the file of one of them");
}

TEST_F(FaultsThoroughly, TwoRunsIntoOneFolderLeaveOneOfThem) {
  auto other = scene;
  other += "--ozone-du 100 --width 120";
  done(other);
  const auto second = files();
  done(scene);
  const auto first = files();
  ASSERT_TRUE(first != second);
  for (int i = 0; i < 8; ++i) {
    auto words = scene;
    words = Words{COPPERMOON_PROGRAM} + words;
    const pid_t one = begun(words);
    coppermoon(other);
    ended(one);
    EXPECT_TRUE(files() == first || files() == second);
  }
  tried("two scenes into one folder at once", "the files of one of them");
}

TEST_F(Faults, AClockThatIsSetBackChangesNothing) {
  if (address_sanitizer) GTEST_SKIP() << "AddressSanitizer has to be the first library loaded";
  done(bake);
  const auto usual = files();
  fs::remove(here("moon.exr"));
  expect_done(coppermoon(bake, {.preloaded = COPPERMOON_CLOCK_SET_BACK}));
  EXPECT_TRUE(files() == usual);
  fs::last_write_time(here("moon.exr"),
                      fs::file_time_type::clock::now() + std::chrono::hours(24 * 365));
  done(bake);
  EXPECT_TRUE(files() == usual);
  tried("the clock set back a day at each look, a file from next year", "the same bytes");
}

TEST_F(FaultsThoroughly, SumsThatAreSpoiltAreRefused) {
  auto photons = bake;
  photons += "--solver photons --photons 2e3 --smoothing-km 300";
  auto keep = photons, add = photons;
  keep += "--keep sums.json";
  add += "--add sums.json";
  done(keep);
  const auto sums = text_of(here("sums.json"));
  fs::remove(here("moon.exr"));
  Outcome outcome;
  for (int tenth = 0; tenth < 10; ++tenth) {
    file("sums.json", sums.substr(0, sums.size() * static_cast<std::size_t>(tenth) / 10));
    outcome = coppermoon(add);
    expect_one_line(outcome, fmt::format("{} tenths of the sums", tenth));
    EXPECT_FALSE(fs::exists(here("moon.exr"))) << tenth;
  }
  refused("photons' sums that end early", said(outcome));
}

}  // namespace coppermoon::extremes::faults_test
