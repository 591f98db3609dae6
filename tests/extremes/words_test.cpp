// SPDX-License-Identifier: MIT
// Names from anyone: each is used to the letter, or refused in one line, and no part of it is taken
// for an order by a shell, POV-Ray or gnuplot.
#include <nlohmann/json.hpp>

#include "extremes/untrusted.h"
#include "povray_scenes/moon_scene.h"
#include "povray_scenes/render.h"
#include "support/testing.h"
#include "support/thorough.h"
#include "texture/read_image.h"
#include "texture/write_image.h"

namespace coppermoon::extremes::words_test {

/// Names without their ending. Whoever takes one for an order makes a file `evil`.
const Words all_names{"qu\"ote, it's",
                      "quote'\nsystem('touch evil')\n'",
                      "$(touch evil) `touch evil`",
                      "a; touch evil | touch evil &",
                      "line\n#fopen Evil \"evil\" write",
                      "per%cent%s%n%04d.####.<UDIM>",
                      "--json",
                      "..",
                      "back\\slash\\n what?is=this#that",
                      "{}",
                      "[a,b]",
                      "tab\tbell\a\x1b[31m caf\xC3\xA9",
                      "\n[atmosphere]\nmodel = 'none'"};

/// Those that are tried wherever a name may stand.
const Words names = support::thorough()
                        ? all_names
                        : Words{all_names[0], all_names[2], all_names[11], all_names[12]};

/// 255 bytes with their ending: as many as a file's name may have.
std::string longest(const std::string& ending) {
  return std::string(255 - ending.size(), 'n') + ending;
}

class Names : public Untrusted {
 protected:
  void SetUp() override { std::filesystem::create_directory(here("inside")); }

  /// Where the programs run; all above is looked at too.
  Outcome inside(const Words& words) const { return coppermoon(words, {.folder = here("inside")}); }

  std::filesystem::path named(const std::string& name) const { return here("inside") / name; }

  /// Done, and beside what was there before only these files stand anywhere.
  void expect_made(const std::string& what, const Outcome& outcome, std::set<std::string> before,
                   const Words& made) const {
    EXPECT_EQ(outcome.status, 0) << what << ": " << outcome.err;
    for (const auto& name : made) before.insert("here/inside/" + name);
    EXPECT_EQ(listing(), before) << what;
  }

  void say(const char* what, const char* holds) const {
    tried(fmt::format("{}: {} names of quotes, newlines, $( ), `, ;, |, %, *, ?, \\", what,
                      names.size()),
          holds);
  }
};

TEST_F(Names, OfTexturesAreUsedToTheLetter) {
  for (const auto& name : names) {
    const auto before = listing();
    const auto outcome = inside(bake({"--albedo-map", "built-in", "--output=" + name + ".exr"}));
    expect_made(name, outcome, before, {name + ".exr"});
    EXPECT_EQ(std::ranges::count(outcome.out, '\n'), 1) << outcome.out;
    EXPECT_SAYS_NOT(outcome.out, '\x1b');
  }
  say("bake -o", "the one file of that name");
}

using NamesThoroughly = Names;

/// The recipe in the header holds the map's name: what it makes again has the same bytes.
TEST_F(NamesThoroughly, OfMapsAreReadToTheLetterAndKeptInRecipes) {
  oiiotool("--pattern noise 8x4 1 --clamp:min=0:max=1 -d uint8 -o map.png");
  for (const auto& name : names) {
    std::filesystem::copy_file(here("map.png"), named(name + ".png"));
    const auto before = listing();
    expect_made(name, inside(bake({"--albedo-map=" + name + ".png", "--output=first.exr"})), before,
                {"first.exr"});
    expect_made(name, inside("bake first.exr -o again.exr"), before, {"first.exr", "again.exr"});
    EXPECT_EQ(text_of(named("first.exr")), text_of(named("again.exr"))) << name;
    for (const char* made : {"first.exr", "again.exr"}) std::filesystem::remove(named(made));
  }
  say("--albedo-map", "read, and read again from the header's recipe: the same bytes");
}

/// Light that is computed, too: its knobs stand in the recipe, line by line.
TEST_F(Names, OfMapsDoNotBecomeLinesOfARecipe) {
  oiiotool("--create 8x4 1 --addc 0.5 -d uint8 -o map.png");
  for (const std::string name : {"a\nrays = 7\nb", "\n[atmosphere]\n", "'''\nseed = 3\n'''"}) {
    std::filesystem::copy_file(here("map.png"), named(name + ".png"));
    const auto outcome = inside(words_of("bake {} --rays 50 --texture-width 16 {} --json -o a.exr",
                                         eclipse_of_2008, "--albedo-map=" + name + ".png"));
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto chosen = nlohmann::json::parse(outcome.out)["chosen"];
    EXPECT_EQ(chosen["albedo-map"], name + ".png");
    EXPECT_EQ(chosen["rays"], 50);
    EXPECT_EQ(chosen["seed"], 1);
  }
  tried("--albedo-map: names that hold lines of a recipe", "the recipe says what was asked for");
}

TEST_F(Names, OfRecipesAreReadToTheLetter) {
  for (const auto& name : names) {
    std::ofstream(named(name + ".toml")) << "albedo-map = 'built-in'\n";
    const auto before = listing();
    expect_made(name, inside(bake({"--recipe=" + name + ".toml", "-o", "a.exr"})), before,
                {"a.exr"});
    std::filesystem::remove(named("a.exr"));
  }
  std::ofstream(named(all_names[1] + ".toml")) << "sead = 5\n";
  expect_refused("a recipe of a name of three lines",
                 inside(bake({"--recipe=" + all_names[1] + ".toml", "-o", "b.exr"})),
                 "the nearest is seed", wrong_usage);
  say("--recipe", "read");
}

TEST_F(Names, OfFramesAreDevelopedToTheLetter) {
  texture::write_exr(here("frame.exr"), texture::Image(4, 2, {"R", "G", "B"}), {});
  for (const auto& name : names) {
    std::filesystem::copy_file(here("frame.exr"), named(name + ".exr"));
    const auto before = listing();
    const auto outcome =
        inside({"develop", "--frame=" + name + ".exr", "--output=" + name + ".png", "--json"});
    expect_made(name, outcome, before, {name + ".png"});
    EXPECT_EQ(nlohmann::json::parse(outcome.out)["file"], name + ".png");
  }
  say("develop", "the one picture of that name");
}

TEST_F(Names, ThatAreNoUtf8AreRefused) {
  for (const std::string name : {"\xFF\xFE", "caf\xE9", "\xC3", "\xED\xA0\x80", "\xC0\xAF"}) {
    const auto before = listing();
    const auto outcome = inside(bake({"--output=" + name + ".exr"}));
    expect_refused("a name that is no UTF-8", outcome, "allowed is UTF-8", wrong_usage);
    EXPECT_EQ(listing(), before);
  }
}

TEST_F(Names, OfTheMostBytesAreUsedOrRefused) {
  auto before = listing();
  const auto outcome = inside(bake(words_of("--albedo-map built-in -o {}", longest(".exr"))));
  expect_made(longest(".exr"), outcome, before, {longest(".exr")});
  tried("a texture's name of 255 bytes", "the one file of that name");
  before = listing();
  expect_refused("a texture's name of 256 bytes",
                 inside(bake(words_of("--albedo-map built-in -o {}", "n" + longest(".exr")))),
                 "File name too long");
  expect_refused("a map's name of 256 bytes",
                 inside(bake(words_of("--albedo-map {} -o a.exr", "n" + longest(".png")))),
                 "File name too long");
  expect_refused("a recipe's name of 100 kB",
                 inside(bake(words_of("--recipe {} -o a.exr", std::string(100'000, 'n')))),
                 "cannot be read");
  EXPECT_EQ(listing(), before);
  std::ofstream(named(longest(".toml"))) << "albedo-map = 'built-in'\n";
  EXPECT_EQ(inside(bake(words_of("--recipe {} -o a.exr", longest(".toml")))).status, 0);
}

class Plots : public Names {};

TEST_F(Plots, AreDrawnIntoTheNameToTheLetter) {
  for (const auto& name : names) {
    const auto before = listing();
    const auto outcome =
        inside(words_of("shadow {} --rays 20 --axis-distances 0,1000 --wavelengths 550 {}",
                        eclipse_of_2008, "--output=" + name + ".png"));
    expect_made(name, outcome, before, {name + ".png"});
    EXPECT_TRUE(text_of(named(name + ".png")).starts_with("\x89PNG")) << name;
  }
  say("shadow -o", "the one picture of that name: gnuplot hears no name");
}

/// What `scene` and `still` take to be quick.
Words tiny(const char* verb, const Words& more) {
  return words_of(
             "{} {} --unshadowed --texture-width 16 --width 8 --height 8 --albedo-map built-in",
             verb, eclipse_of_2008) +
         more;
}

class Scenes : public Names {
 protected:
  static Words files_in(const std::string& folder) {
    return {folder, folder + "/eclipse.ini", folder + "/eclipse.pov",
            folder + "/moon_lin_rec709.exr"};
  }
};

using ScenesThoroughly = Scenes;

/// Nothing of the folder's name stands in its files, so none of it can be an order.
TEST_F(ScenesThoroughly, AreTheSameInFoldersOfAnyName) {
  inside(tiny("scene", "-o plain"));
  for (const auto& name : names + Words{longest("")}) {
    if (name == "..") continue;
    const auto before = listing();
    expect_made(name, inside(tiny("scene", {"--output=" + name})), before, files_in(name));
    for (const char* file : {"eclipse.ini", "eclipse.pov", "moon_lin_rec709.exr"})
      EXPECT_EQ(text_of(named(name) / file), text_of(named("plain") / file)) << name;
  }
  say("scene -o", "a folder of that name, its files those of any other");
}

TEST_F(Scenes, InTheFolderAboveAreWhereTheyAreAskedFor) {
  EXPECT_EQ(inside(tiny("scene", "-o ..")).status, 0);
  const std::set<std::string> expected{"here/eclipse.ini", "here/eclipse.pov", "here/inside",
                                       "here/moon_lin_rec709.exr"};
  EXPECT_EQ(listing(), expected);
}

TEST_F(ScenesThoroughly, RenderInFoldersOfAnyName) {
  for (const auto& name : {all_names[0], all_names[1], all_names[2], all_names[4], all_names[6],
                           all_names[8], all_names[11]}) {
    ASSERT_EQ(inside(tiny("scene", {"--output=" + name})).status, 0);
    const auto before = listing();
    povray_scenes::render(named(name), {.threads = 1});
    expect_made(name, {0, {}, {}}, before, {name + "/frame.exr"});
  }
  tried("a scene's folder of a name of quotes, newlines, $( ), `, \\", "frame.exr in it alone");
}

class Stills : public Names {};

using StillsThoroughly = Stills;

TEST_F(StillsThoroughly, AreUsedToTheLetter) {
  for (const auto& name : names) {
    const auto before = listing();
    const auto outcome =
        inside(tiny("still", {"--output=" + name + ".png", "--frame=" + name + ".exr", "--json"}));
    expect_made(name, outcome, before, {name + ".png", name + ".exr"});
  }
  say("still -o, --frame", "the picture and the frame of that name");
}

/// POV-Ray runs in a temporary folder, whose name is the environment's word.
TEST_F(StillsThoroughly, AreRenderedWhereverTemporaryFilesGo) {
  for (const auto& name : {all_names[0], all_names[1], all_names[4]}) {
    const auto folder = named(name);
    std::filesystem::create_directory(folder);
    const auto before = listing();
    const auto outcome = run(Words{"env", "TMPDIR=" + folder.string(), COPPERMOON_PROGRAM} +
                             tiny("still", "-o a.png"));
    EXPECT_EQ(outcome.status, 0) << name << ": " << outcome.err;
    std::filesystem::remove(here("a.png"));
    EXPECT_EQ(listing(), before) << name;
  }
  tried("TMPDIR of a name of quotes, newlines, #fopen", "a still, and nothing left there");
}

}  // namespace coppermoon::extremes::words_test
