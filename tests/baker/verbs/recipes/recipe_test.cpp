// SPDX-License-Identifier: MIT
#include "verbs/recipes/recipe.h"

#include <unistd.h>
#include <CLI/CLI.hpp>

#include "support/testing.h"
#include "texture/write_image.h"
#include "uses/light/light_parameters.h"
#include "verbs/flags/verb.h"

namespace coppermoon::verbs {
namespace {

using Words = std::vector<std::string>;

/// A program of one word, with a flag of each kind.
struct Program {
  CLI::App app;
  Verb* verb;
  std::string instant, output, map = "auto";
  double dust = 0;
  std::uint64_t seed = 1;
  int rays = 600;
  std::string waves;
  bool unshadowed = false, run = false;

  explicit Program(bool dusty = true) {
    app.option_defaults()->always_capture_default()->multi_option_policy(
        CLI::MultiOptionPolicy::TakeLast);
    verb = dynamic_cast<Verb*>(add_verb(app, "bake", ""));
    add_flag(*verb, "instant,--instant", instant, "");
    add_flag(*verb, "--albedo-map", map, "").reads_file();
    if (dusty) add_flag(*verb, "--dust-extinction", dust, "");
    add_flag(*verb, "--seed", seed, "");
    add_flag(*verb, "--rays", rays, "");
    add_flag(*verb, "--waves", waves, "");
    add_flag(*verb, "-o,--output", output, "").writes_file();
    add_switch(*verb, "--unshadowed", unshadowed, "");
    for (const char* of_run : {"--json", "--csv", "--replace"})
      add_switch(*verb, of_run, run, "").of(request::Affects::run);
    add_recipe_option(*verb);
  }

  std::string recipe_after(Words words) {
    std::reverse(words.begin(), words.end());
    app.parse(words);
    return recipe_of(*verb);
  }
};

/// The same with the Earth's air.
struct AirProgram : Program {
  uses::Air air;

  AirProgram() : Program(false) { add_described(*verb, air); }
};

class Recipe : public testing::Test {
 protected:
  void write(const std::string& text) const { std::ofstream(path) << text; }
  ~Recipe() override { std::filesystem::remove(path); }
  /// What is wrong with a recipe of the air.
  std::string error_in(const std::string& text) const;
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

std::string Recipe::error_in(const std::string& text) const {
  write(text);
  const auto error = error_of(AirProgram().app, {"bake", "--recipe", path});
  EXPECT_TRUE(error.starts_with(path + ":")) << error;
  return error.substr(std::min(error.size(), path.size() + 1));
}

const std::string south = "from-latitude=-90,to-latitude=0", region = "\n[[atmosphere.region]]\n";

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
  EXPECT_SAYS(error_of(program.app, {"bake", "--ray", "5"}), "did you mean --rays?");
  EXPECT_SAYS(error_of(program.app, {"bale"}), "did you mean bake?");
}

TEST_F(Recipe, NamesFileAndLineOfAnUnknownKey) {
  write("# first\n\nrayz = 5\n");
  const auto error = error_of(program.app, {"bake", "--recipe", path});
  EXPECT_SAYS(error, path + ":3: rayz");
  EXPECT_SAYS(error, "the nearest is rays");
}

TEST_F(Recipe, SaysNothingOfTheRunItself) {
  for (const char* key : {"help", "help-all", "json", "csv", "threads", "recipe", "replace"}) {
    write(std::string("rays = 5\n") + key + " = 1\n");
    const auto error = error_of(program.app, {"bake", "--recipe", path});
    EXPECT_EQ(error, path + ":2: " + key + ": how a run goes is said on the command line alone");
  }
}

TEST_F(Recipe, OfAFilmsFileIsThatOfItsFrame) {
  const auto frame = testing::TempDir() + "frame_" + std::to_string(::getpid()) + ".png";
  const auto words_for = [&](const std::string& mount) {
    texture::write_png(
        frame, texture::Image(2, 2, {"Y"}), 8,
        {{"coppermoon:recipe", "eclipse = '2018-07-27'\ncalendar = 'julian'\nfield = 1\nmount = '" +
                                   mount + "'\nup = 'celestial-north'\ntime = 'U1:1/100,U2:1'\n"},
         {"coppermoon:instant", std::string("2018-07-27T18:57:22.399Z")},
         {"expTime", 0.5F}});
    return with_recipes(program.app, {"bake", frame});
  };
  for (const char* flag : {"--calendar", "--field", "--up", "--time"})
    add_flag(*program.verb, flag, program.waves, "");
  EXPECT_EQ(words_for("horizon"), Words({"bake", "--field=1", "--instant=2018-07-27T18:57:22.399Z",
                                         "--calendar=gregorian", "--up=zenith", "--time=0.5"}));
  EXPECT_EQ(words_for("tracking"),
            Words({"bake", "--field=1", "--up=celestial-north",
                   "--instant=2018-07-27T18:57:22.399Z", "--calendar=gregorian", "--time=0.5"}));
  EXPECT_THROW(words_for("fixed"), algebra::Error);
  EXPECT_EQ(with_recipes(program.app, {"bake", "--recipe", frame, "2020-01-10"}),
            Words({"bake", "--calendar=julian", "--field=1", "--time=U1:1/100,U2:1",
                   "--up=celestial-north", "--instant=2020-01-10"}));
  std::filesystem::remove(frame);
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

TEST_F(Recipe, NamesFilesWithoutTheFoldersOfTheUser) {
  const auto recipe = Program().recipe_after({"bake", "--albedo-map", "/home/alice/maps/moon.tif"});
  EXPECT_SAYS(recipe, "albedo-map = 'moon.tif'\n");
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

TEST_F(Recipe, RefusesAnEmptyValueThatWouldTakeTheNextFlagForIts) {
  write("rays = 5\nalbedo-map = \"\"\n");
  EXPECT_EQ(error_of(program.app, {"bake", "--recipe", path}),
            path + ":2: albedo-map: is empty; leave it out instead");
}

constexpr const char* plume =
    "rays = 50\n"
    "[atmosphere]\n"
    "model = \"clear\"\n"
    "ozone-du = 300\n"
    "refraction = false\n"
    "[[atmosphere.region]]\n"
    "from-latitude = -90\n"
    "to-latitude = 0\n"
    "dust-extinction = 1e-5\n"
    "[[atmosphere.region]]\n"
    "from-position-angle = 330\n"
    "to-position-angle = 30\n"
    "stratospheric-aerosol = \"high\"\n";

TEST_F(Recipe, OfTheAirMayStandInATable) {
  write(plume);
  EXPECT_EQ(with_recipes(AirProgram().app, {"bake", "--recipe", path}),
            Words({"bake", "--rays=50", "--atmosphere=clear", "--ozone-du=300", "--refraction=off",
                   "--region=dust-extinction=1e-05,from-latitude=-90,to-latitude=0",
                   "--region=from-position-angle=330,stratospheric-aerosol=high,"
                   "to-position-angle=30"}));
}

TEST_F(Recipe, OfTheAirMayStandAboveAllTables) {
  write("atmosphere = \"paper\"\nozone-du = 300\nregion = [\"" + south +
        "\", \"from-position-angle=0,to-position-angle=9\"]\n");
  EXPECT_EQ(with_recipes(AirProgram().app, {"bake", "--recipe", path}),
            Words({"bake", "--atmosphere=paper", "--ozone-du=300", "--region=" + south,
                   "--region=from-position-angle=0,to-position-angle=9"}));
}

TEST_F(Recipe, LosesItsRegionsToTheUsersAndNothingElse) {
  write(plume);
  const Words mine{"bake", "--region", south + ",cloud-cover=1", "--recipe", path};
  EXPECT_EQ(with_recipes(AirProgram().app, mine),
            Words({"bake", "--rays=50", "--atmosphere=clear", "--ozone-du=300", "--refraction=off",
                   "--region", south + ",cloud-cover=1"}));
}

TEST_F(Recipe, LosesItsModelToTheUsersAtmosphere) {
  write(plume);
  const auto words =
      with_recipes(AirProgram().app, {"bake", "--recipe", path, "--atmosphere=paper"});
  EXPECT_EQ(std::count(words.begin(), words.end(), "--atmosphere=clear"), 0);
  EXPECT_EQ(std::count_if(words.begin(), words.end(),
                          [](const auto& word) { return word.starts_with("--region="); }),
            2);
}

TEST_F(Recipe, NamesTheNearestOfAnUnknownKeyInEachTable) {
  EXPECT_EQ(error_in("[atmosphere]\n\nozon-du = 300\n"),
            "3: ozon-du: [atmosphere] has no such key; the nearest is ozone-du");
  EXPECT_EQ(error_in("[atmosphere]\nmodle = \"paper\"\n"),
            "2: modle: [atmosphere] has no such key; the nearest is model");
  EXPECT_EQ(error_in(region + "from-latitude = -90\nto-lattitude = 0\n"),
            "4: to-lattitude: a region has no such key; the nearest is to-latitude");
}

TEST_F(Recipe, SaysWhereAFlagBelongsThatStandsInATable) {
  EXPECT_EQ(error_in("[atmosphere]\nrays = 50\n"),
            "2: rays: [atmosphere] has no such key; it belongs above all tables");
  EXPECT_EQ(error_in(region + "refraction = \"off\"\n"),
            "3: refraction: a region has no such key; it belongs above all tables");
}

TEST_F(Recipe, TellsEachFlagOnce) {
  EXPECT_EQ(error_in("ozone-du = 300\n[atmosphere]\nozone-du = 200\n"),
            "3: ozone-du: given twice, above all tables and in [atmosphere]");
  EXPECT_TRUE(error_in("atmosphere = \"paper\"\n[atmosphere]\n").starts_with("2: "));
}

TEST_F(Recipe, RefusesARegionThatDoesNotSayWhereItIs) {
  const std::string ends =
      ": needs from-latitude and to-latitude, or from-position-angle and to-position-angle "
      "[degrees]";
  EXPECT_EQ(error_in(region), "2: region ''" + ends);
  EXPECT_EQ(error_in(region + "cloud-cover = 1\n"), "2: region 'cloud-cover=1'" + ends);
  EXPECT_EQ(error_in(region + "from-latitude = -90\n"), "2: region 'from-latitude=-90'" + ends);
  for (const char* more :
       {"from-position-angle = 3\n", "from-position-angle = 3\nto-position-angle = 4\n"}) {
    const auto error = error_in(region + "from-latitude = -90\nto-latitude = 0\n" + more);
    EXPECT_TRUE(error.ends_with(ends)) << error;
  }
}

TEST_F(Recipe, NamesFileAndLineOfABadValueInARegion) {
  const std::string where = region + "from-latitude = -90\nto-latitude = 0\n";
  const auto much = error_in(where + "dust-extinction = \"much\"\n");
  EXPECT_TRUE(much.starts_with("2: region 'dust-extinction=much,")) << much;
  const auto word = error_in(where + "stratospheric-aerosol = \"thick\"\n");
  EXPECT_TRUE(word.starts_with("2: region '")) << word;
  EXPECT_SAYS(word, "moderate");
  for (const char* value : {"[1, 2]", "\"1,cloud-top-km=3\"", "\"\"", "[]"}) {
    const auto error = error_in(where + "cloud-cover = " + value + "\n");
    EXPECT_TRUE(error.starts_with("5: cloud-cover = ")) << error;
    EXPECT_TRUE(error.ends_with("allowed is a number or a word")) << error;
  }
  EXPECT_TRUE(error_in(where + "cloud-cover = {}\n").starts_with("5: cloud-cover: allowed are "));
}

TEST_F(Recipe, WritesRegionsAsTablesAtTheEnd) {
  AirProgram air;
  const auto text = air.recipe_after({"bake", "--region",
                                      "cloud-cover=.5,from-latitude=-90.0,"
                                      "to-latitude=0",
                                      "--atmosphere", "clear", "--region",
                                      "from-position-angle=330,to-position-angle=30,"
                                      "stratospheric-aerosol=high"});
  EXPECT_SAYS_NOT(text, "atmosphere = ");
  EXPECT_TRUE(
      text.ends_with("\n[atmosphere]\nmodel = 'clear'\n"
                     "\n[[atmosphere.region]]\nfrom-latitude = -90\nto-latitude = 0\n"
                     "cloud-cover = 0.5\n"
                     "\n[[atmosphere.region]]\nfrom-position-angle = 330\n"
                     "to-position-angle = 30\nstratospheric-aerosol = 'high'\n"))
      << text;
}

TEST_F(Recipe, WithoutRegionsHasNoTables) {
  const auto text = AirProgram().recipe_after({"bake", "--atmosphere", "clear"});
  EXPECT_SAYS(text, "\natmosphere = 'clear'\n");
  EXPECT_SAYS_NOT(text, "region");
  EXPECT_SAYS_NOT(text, '[');
}

TEST_F(Recipe, WithRegionsRoundsTripThroughAFile) {
  write(plume);
  const auto first = AirProgram().recipe_after(
      with_recipes(AirProgram().app, {"bake", "2008-02-21", "--recipe", path}));
  write(first);
  const auto second =
      AirProgram().recipe_after(with_recipes(AirProgram().app, {"bake", "--recipe", path}));
  EXPECT_EQ(second, first);
  EXPECT_SAYS(first, "dust-extinction = 1e-05");
}

TEST_F(Recipe, KeepsARegionThatStandsTwice) {
  const std::string twice = region + "from-latitude = -90\nto-latitude = 0\n" + region +
                            "from-latitude = -90\nto-latitude = 0\n";
  write(twice);
  AirProgram air;
  const auto text = air.recipe_after(with_recipes(air.app, {"bake", "--recipe", path}));
  EXPECT_TRUE(text.ends_with(twice)) << text;
  EXPECT_EQ(air.air.regions.size(), 2U);
}

}  // namespace
}  // namespace coppermoon::verbs
