// SPDX-License-Identifier: MIT
#include "verbs/recipe.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>

#include "algebra/error.h"

namespace coppermoon::verbs {
namespace {

using Words = std::vector<std::string>;

/// A program of one word, with a flag of each kind.
struct Program {
  CLI::App app;
  CLI::App* verb;
  std::string instant, output, map = "auto";
  double dust = 0;
  std::uint64_t seed = 1;
  int rays = 600;
  std::string waves;
  bool unshadowed = false;

  Program() {
    app.option_defaults()->always_capture_default()->multi_option_policy(
        CLI::MultiOptionPolicy::TakeLast);
    verb = app.add_subcommand("bake");
    verb->add_option("instant,--instant", instant);
    verb->add_option("--albedo-map", map);
    verb->add_option("--dust-extinction", dust);
    verb->add_option("--seed", seed);
    verb->add_option("--rays", rays);
    verb->add_option("--waves", waves);
    verb->add_option("-o,--output", output);
    verb->add_flag("--unshadowed", unshadowed);
    add_recipe_option(*verb);
  }

  std::string recipe_after(Words words) {
    std::reverse(words.begin(), words.end());
    app.parse(words);
    return recipe_of(*verb);
  }
};

class Recipe : public testing::Test {
 protected:
  void write(const std::string& text) const { std::ofstream(path) << text; }
  ~Recipe() override { std::filesystem::remove(path); }
  std::string path = testing::TempDir() + "recipe_" + std::to_string(::getpid()) + ".toml";
  Program program;
};

std::string error_of(const CLI::App& app, const Words& words) {
  try {
    with_recipes(app, words);
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

TEST_F(Recipe, BecomesFlagsBehindTheWord) {
  write("rays = 50\ndust-extinction = 1e-6\nunshadowed = true\nwaves = [1, 2.5]\n");
  const auto words = with_recipes(program.app, {"bake", "2008-02-21", "--recipe", path});
  EXPECT_EQ(words, Words({"bake", "--dust-extinction=1e-06", "--rays=50", "--unshadowed=true",
                          "--waves=1,2.5", "--instant=2008-02-21"}));
}

TEST_F(Recipe, LeavesOutWhatTheUserSays) {
  write("rays = 50\ninstant = 2008-02-21T03:00:00Z\nwaves = [1, 2]\n");
  const auto words = with_recipes(
      program.app, {"bake", "--waves=3", "-o", "x.exr", "2010-12-21", "--recipe=" + path});
  EXPECT_EQ(words,
            Words({"bake", "--rays=50", "--waves=3", "-o", "x.exr", "--instant=2010-12-21"}));
}

TEST_F(Recipe, LeavesWordsWithoutARecipeAlone) {
  const Words words{"bake", "2008-02-21", "--rays", "50", "-o", "x.exr"};
  EXPECT_EQ(with_recipes(program.app, words), words);
  EXPECT_EQ(with_recipes(program.app, {"--version"}), Words{"--version"});
}

TEST_F(Recipe, NamesTheNearestOfAnUnknownFlag) {
  EXPECT_NE(error_of(program.app, {"bake", "--ray", "5"}).find("the nearest is --rays"),
            std::string::npos);
  EXPECT_NE(error_of(program.app, {"bale"}).find("the nearest is bake"), std::string::npos);
}

TEST_F(Recipe, NamesFileAndLineOfAnUnknownKey) {
  write("# first\n\nrayz = 5\n");
  const auto error = error_of(program.app, {"bake", "--recipe", path});
  EXPECT_NE(error.find(path + ":3: rayz"), std::string::npos) << error;
  EXPECT_NE(error.find("the nearest is rays"), std::string::npos) << error;
}

TEST_F(Recipe, NamesFileAndLineOfASyntaxError) {
  write("rays = 5\nseed = \n");
  EXPECT_TRUE(error_of(program.app, {"bake", "--recipe", path}).starts_with(path + ":2: "));
}

TEST_F(Recipe, OfAWordHoldsAllButWhereResultsGo) {
  EXPECT_EQ(program.recipe_after({"bake", "2008-02-21", "-o", "x.exr", "--unshadowed"}),
            "instant = '2008-02-21'\nalbedo-map = 'auto'\ndust-extinction = 0\nseed = 1\nrays = "
            "600\nunshadowed = true\n");
}

TEST_F(Recipe, SpellsNumbersAlikeAndTextsAsTheyAre) {
  EXPECT_EQ(
      program.recipe_after({"bake", "--dust-extinction", ".5e-6", "--seed", "18446744073709551615",
                            "--albedo-map", "007"}),
      "albedo-map = '007'\ndust-extinction = 5e-07\nseed = '18446744073709551615'\nrays = 600\n");
}

TEST_F(Recipe, RoundsTripThroughAFile) {
  const auto first =
      Program().recipe_after({"bake", "2008-02-21", "--waves", "1.5,2", "--dust-extinction", "0.1",
                              "--seed", "3", "--albedo-map", "it's \"a\" map\\.png"});
  write(first);
  EXPECT_EQ(Program().recipe_after(with_recipes(program.app, {"bake", "--recipe", path})), first);
}

}  // namespace
}  // namespace coppermoon::verbs
