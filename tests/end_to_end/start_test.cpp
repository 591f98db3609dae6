// SPDX-License-Identifier: MIT
// The program starts without OpenImageIO, and loads it from its module when it first needs an image.
#include "support/program.h"

namespace coppermoon::end_to_end::start_test {

namespace fs = std::filesystem;

constexpr const char *eclipsed = "2008-02-21T03:26:05Z", *module_name = "coppermoon_images.so";

const auto tiny_bake = words_of(
    "bake {} --texture-width 64 --bands 4 --albedo-map built-in --rays 60 -o moon.exr", eclipsed);

fs::path module_file() { return fs::path(COPPERMOON_PROGRAM).replace_filename(module_name); }

class Start : public ProgramTest {
 protected:
  /// The program alone, as if its module had been lost; in a folder of its own.
  fs::path copy_alone() const {
    fs::create_directories(here("bin"));
    const auto program = here("bin/coppermoon");
    fs::copy_file(COPPERMOON_PROGRAM, program, fs::copy_options::overwrite_existing);
    return program;
  }

  void expect_error(const Words& words, const std::string& why) const {
    const auto outcome = run(words);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.err, "coppermoon: " + why + "\n");
    EXPECT_FALSE(fs::exists(here("moon.exr")));
  }
};

TEST_F(Start, NeedsNoOpenImageIO) {
  const auto libraries = run({"env", "LD_TRACE_LOADED_OBJECTS=1", COPPERMOON_PROGRAM}).out;
  EXPECT_SAYS(libraries, "libtbb");
  EXPECT_SAYS_NOT(libraries, "libOpenImageIO");
}

TEST_F(Start, WhatTouchesNoImageNeedsNoModule) {
  const auto program = copy_alone().string();
  expect_done(run({program, "--version"}));
  expect_done(run({program, "--help"}));
  for (const char* verb :
       {"almanac", "sky", "plan", "shadow", "brightness", "bake", "ring", "dome", "shader", "scene",
        "still", "animate", "develop", "merge", "compare", "fit", "tradeoff", "describe", "cache"})
    expect_done(run({program, verb, "--help"}));
  expect_done(run(words_of("{} almanac --from 2008-01-01 --to 2008-12-31", program)));
  expect_done(run({program, "sky", eclipsed}));
  expect_done(run(words_of("{} plan {} --albedo-map built-in", program, eclipsed)));
  expect_done(run(words_of("{} shadow {} --tolerance 20% --axis-distances 0", program, eclipsed)));
}

TEST_F(Start, AModuleThatIsLostIsNamedInOneLine) {
  const auto program = copy_alone().string();
  const auto lost =
      (fs::canonical(here("bin")) / COPPERMOON_MODULES / module_name).lexically_normal();
  const auto why =
      lost.string() +
      ": no such file; it is installed with the program, and reads and writes its images";
  expect_error(Words{program} + tiny_bake, why);
  expect_error(words_of("{} develop {} -o a.png", program, file("a.exr", "")), why);
}

TEST_F(Start, AModuleThatIsNoneOrOfAnotherVersionIsRefused) {
  const auto program = copy_alone().string();
  const auto module = fs::canonical(here("bin")).string() + "/" + module_name;
  file(std::string("bin/") + module_name, "no library");
  expect_error(Words{program} + tiny_bake,
               module + ": cannot be loaded: " + module + ": file too short");
  const std::string ours = std::string(COPPERMOON_VERSION) + '\0';
  auto other = ours;
  std::ranges::fill(other.begin(), other.end() - 1, '9');
  auto bytes = text_of(module_file());
  for (auto at = bytes.find(ours); at != bytes.npos; at = bytes.find(ours, at))
    bytes.replace(at, ours.size(), other);
  file(std::string("bin/") + module_name, bytes);
  expect_error(Words{program} + tiny_bake, module + ": belongs to coppermoon " + other.c_str() +
                                               ", allowed " + COPPERMOON_VERSION);
}

TEST_F(Start, TheModuleIsFoundThroughALinkAndWhereverBothAreMovedTo) {
  fs::create_symlink(COPPERMOON_PROGRAM, here("linked"));
  EXPECT_EQ(run(Words{here("linked").string()} + tiny_bake).status, 0);
  const auto bytes = text_of(here("moon.exr"));
  fs::remove(here("moon.exr"));
  const auto program = copy_alone();
  const auto modules = (here("bin") / COPPERMOON_MODULES).lexically_normal();
  fs::create_directories(modules);
  fs::copy_file(module_file(), modules / module_name);
  fs::rename(here("bin"), here("programs"));
  const auto moved = run(Words{here("programs/coppermoon").string()} + tiny_bake);
  EXPECT_EQ(moved.status, 0) << moved.err;
  EXPECT_EQ(text_of(here("moon.exr")), bytes);
}

TEST_F(Start, WhatTheModuleThrowsIsOneLineLikeAnyError) {
  expect_error(words_of("{} develop none.exr -o a.png", COPPERMOON_PROGRAM),
               "none.exr: cannot be read: no such file");
  file("empty.exr", "");
  expect_error(words_of("{} develop empty.exr -o a.png", COPPERMOON_PROGRAM),
               "empty.exr: cannot be read: it is empty");
}

}  // namespace coppermoon::end_to_end::start_test
