// SPDX-License-Identifier: MIT
#include <unistd.h>

#include "request/recipe.h"
#include "support/testing.h"
#include "texture/write_image.h"
#include "uses/light/light_parameters.h"
#include "verbs/command_line.h"
#include "verbs/recipes/recipe_file.h"

namespace coppermoon::verbs::recipe_test {

using Words = std::vector<std::string>;

/// A program of one command, with a flag of each kind.
struct OneCommand {
  Program program;
  Verb& verb;
  std::string instant, output, map = "auto";
  double dust = 0;
  std::size_t seed = 1;
  int rays = 600;
  std::string waves;
  bool unshadowed = false, run = false;

  explicit OneCommand(bool dusty = true) : verb(add_verb(program, "bake", "")) {
    add_flag(verb, "instant,--instant", instant, "");
    add_flag(verb, "--albedo-map", map, "").reads_file();
    if (dusty) add_flag(verb, "--dust-extinction", dust, "");
    add_flag(verb, "--seed", seed, "");
    add_flag(verb, "--rays", rays, "");
    add_flag(verb, "--waves", waves, "");
    add_flag(verb, "-o,--output", output, "").writes_file();
    add_switch(verb, "--unshadowed", unshadowed, "");
    for (const char* of_run : {"--json", "--csv", "--replace"})
      add_switch(verb, of_run, run, "").of(request::Affects::run);
    on_run(verb, [] {});
  }

  std::string recipe_after(const Words& words) {
    take(verb, words);
    return recipe_of(verb);
  }
  /// What was given, as "name=text", in the order of the command's parameters.
  Words given_after(const Words& words) {
    asked_by(program, words);
    Words all;
    for (const auto& parameter : verb.parameters)
      if (parameter.given && parameter.name != "recipe")
        for (const auto& text : *parameter.given) all.push_back(parameter.name + "=" + text);
    return all;
  }
};

/// The same with the Earth's air.
struct AirProgram : OneCommand {
  uses::Air air;

  AirProgram() : OneCommand(false) { add_described(verb, air); }
};

class Recipe : public testing::Test {
 protected:
  void write(const std::string& text) const { std::ofstream(path) << text; }
  ~Recipe() override { std::filesystem::remove(path); }
  /// What is wrong with a recipe of the air.
  std::string error_in(const std::string& text) const;
  std::string path = testing::TempDir() + "recipe_" + std::to_string(::getpid()) + ".toml";
  OneCommand one;
};

std::string error_of(Program& program, const Words& words) {
  try {
    asked_by(program, words);
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

std::string Recipe::error_in(const std::string& text) const {
  write(text);
  AirProgram air;
  const auto error = error_of(air.program, {"bake", "--recipe", path});
  EXPECT_TRUE(error.starts_with(path + ":")) << error;
  return error.substr(std::min(error.size(), path.size() + 1));
}

const std::string south = "from-latitude=-90,to-latitude=0", region = "\n[[atmosphere.region]]\n";

TEST_F(Recipe, GivesTheCommandItsValues) {
  write("rays = 50\ndust-extinction = 1e-6\nunshadowed = true\nwaves = [1, 2.5]\n");
  EXPECT_EQ(one.given_after({"bake", "2008-02-21", "--recipe", path}),
            Words({"instant=2008-02-21", "dust-extinction=1e-06", "rays=50", "waves=1,2.5",
                   "unshadowed=true"}));
  EXPECT_EQ(one.rays, 50);
  EXPECT_EQ(one.verb.typed, Words({"instant", "recipe"}));
}

TEST_F(Recipe, GivesWayToTheUser) {
  write("rays = 50\ninstant = 2008-02-21T03:00:00Z\nwaves = [1, 2]\n");
  EXPECT_EQ(one.given_after({"bake", "--waves=3", "-o", "x.exr", "2010-12-21", "--recipe=" + path}),
            Words({"instant=2010-12-21", "rays=50", "waves=3", "output=x.exr"}));
}

TEST_F(Recipe, NamesFileAndLineOfAnUnknownKey) {
  write("# first\n\nrayz = 5\n");
  const auto error = error_of(one.program, {"bake", "--recipe", path});
  EXPECT_SAYS(error, path + ":3: rayz");
  EXPECT_SAYS(error, "the nearest is rays");
}

TEST_F(Recipe, NamesFileAndLineOfAValueThatIsNotAllowed) {
  write("seed = 3\nrays = 'many'\n");
  EXPECT_EQ(error_of(one.program, {"bake", "--recipe", path}),
            path + ":2: rays = many, allowed a number");
}

TEST_F(Recipe, SaysNothingOfTheRunItself) {
  for (const char* key : {"help", "help-all", "json", "csv", "threads", "recipe", "replace"}) {
    write(std::string("rays = 5\n") + key + " = 1\n");
    const auto error = error_of(one.program, {"bake", "--recipe", path});
    EXPECT_EQ(error, path + ":2: " + key + ": how a run goes is said on the command line alone");
  }
}

TEST_F(Recipe, OfAFilmsFileIsThatOfItsFrame) {
  const auto frame = testing::TempDir() + "frame_" + std::to_string(::getpid()) + ".png";
  const auto given_for = [&](const std::string& mount, const Words& words) {
    texture::write_png(
        frame, texture::Image(2, 2, {"Y"}), 8,
        {{"coppermoon:recipe", "eclipse = '2018-07-27'\ncalendar = 'julian'\nfield = 1\nmount = '" +
                                   mount + "'\nup = 'celestial-north'\ntime = 'U1:1/100,U2:1'\n"},
         {"coppermoon:instant", std::string("2018-07-27T18:57:22.399Z")},
         {"expTime", 0.5F}});
    OneCommand with_camera;
    for (const char* flag : {"--calendar", "--field", "--up", "--time"})
      add_flag(with_camera.verb, flag, with_camera.waves, "");
    return with_camera.given_after(words);
  };
  EXPECT_EQ(given_for("horizon", {"bake", frame}),
            Words({"instant=2018-07-27T18:57:22.399Z", "calendar=gregorian", "field=1", "up=zenith",
                   "time=0.5"}));
  EXPECT_EQ(given_for("tracking", {"bake", frame})[3], "up=celestial-north");
  EXPECT_THROW(given_for("fixed", {"bake", frame}), algebra::Error);
  EXPECT_EQ(given_for("fixed", {"bake", "--recipe", frame, "2020-01-10"}),
            Words({"instant=2020-01-10", "calendar=julian", "field=1", "up=celestial-north",
                   "time=U1:1/100,U2:1"}));
  std::filesystem::remove(frame);
}

TEST_F(Recipe, OfAWordHoldsAllButWhereResultsGo) {
  EXPECT_EQ(one.recipe_after({"2008-02-21", "-o", "x.exr", "--unshadowed"}),
            "instant = '2008-02-21'\nalbedo-map = 'auto'\ndust-extinction = 0\nseed = 1\nrays = "
            "600\nunshadowed = true\n");
}

TEST_F(Recipe, RefusesAnEmptyValue) {
  write("rays = 5\nalbedo-map = \"\"\n");
  EXPECT_EQ(error_of(one.program, {"bake", "--recipe", path}),
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
  EXPECT_EQ(AirProgram().given_after({"bake", "--recipe", path}),
            Words({"rays=50", "atmosphere=clear", "refraction=off", "ozone-du=300",
                   "region=dust-extinction=1e-05,from-latitude=-90,to-latitude=0",
                   "region=from-position-angle=330,stratospheric-aerosol=high,"
                   "to-position-angle=30"}));
}

TEST_F(Recipe, OfTheAirMayStandAboveAllTables) {
  write("atmosphere = \"paper\"\nozone-du = 300\nregion = [\"" + south +
        "\", \"from-position-angle=0,to-position-angle=9\"]\n");
  EXPECT_EQ(AirProgram().given_after({"bake", "--recipe", path}),
            Words({"atmosphere=paper", "ozone-du=300", "region=" + south,
                   "region=from-position-angle=0,to-position-angle=9"}));
}

TEST_F(Recipe, LosesItsRegionsToTheUsersAndNothingElse) {
  write(plume);
  const Words mine{"bake", "--region", south + ",cloud-cover=1", "--recipe", path};
  EXPECT_EQ(AirProgram().given_after(mine),
            Words({"rays=50", "atmosphere=clear", "refraction=off", "ozone-du=300",
                   "region=" + south + ",cloud-cover=1"}));
}

TEST_F(Recipe, LosesItsModelToTheUsersAtmosphere) {
  write(plume);
  const auto given = AirProgram().given_after({"bake", "--recipe", path, "--atmosphere=paper"});
  EXPECT_EQ(std::ranges::count(given, "atmosphere=paper"), 1);
  EXPECT_EQ(std::ranges::count(given, "atmosphere=clear"), 0);
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
  for (const char* value : {"[1, 2]", "\"1,cloud-top-km=3\"", "\"\"", "[]", "{}"}) {
    const auto error = error_in(where + "cloud-cover = " + value + "\n");
    EXPECT_TRUE(error.starts_with("5: cloud-cover = ")) << error;
    EXPECT_TRUE(error.ends_with("allowed is a number or a word")) << error;
  }
}

TEST_F(Recipe, WritesRegionsAsTablesAtTheEnd) {
  AirProgram air;
  const auto text = air.recipe_after({"--region",
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
  const auto text = AirProgram().recipe_after({"--atmosphere", "clear"});
  EXPECT_SAYS(text, "\natmosphere = 'clear'\n");
  EXPECT_SAYS_NOT(text, "region");
  EXPECT_SAYS_NOT(text, '[');
}

TEST_F(Recipe, WithRegionsRoundsTripThroughAFile) {
  write(plume);
  const auto first = AirProgram().recipe_after({"2008-02-21", "--recipe", path});
  write(first);
  EXPECT_EQ(AirProgram().recipe_after({"--recipe", path}), first);
  EXPECT_SAYS(first, "dust-extinction = 1e-05");
}

TEST_F(Recipe, KeepsARegionThatStandsTwice) {
  const std::string twice = region + "from-latitude = -90\nto-latitude = 0\n" + region +
                            "from-latitude = -90\nto-latitude = 0\n";
  write(twice);
  AirProgram air;
  EXPECT_TRUE(air.recipe_after({"--recipe", path}).ends_with(twice));
  EXPECT_EQ(air.air.regions.size(), 2U);
}

}  // namespace coppermoon::verbs::recipe_test
