// SPDX-License-Identifier: MIT
#include "request/recipe.h"

#include <gtest/gtest.h>

#include <optional>

namespace coppermoon::request::recipe_test {

/// A request with a field of each kind, and what its recipe says.
struct Fields {
  double dust = 0;
  std::size_t seed = 1;
  std::string map = "auto", shard;
  std::vector<std::string> waves;
  bool dark = false;
  Parameters parameters;

  Fields() {
    parameters.begin("", "", Affects::light);
    parameters.add(parameter("dust", dust, "dust"));
    parameters.add(parameter("seed", seed, "seed"));
    parameters.add(parameter("albedo-map", map, "map")).reads_file();
    parameters.add(parameter("waves", waves, "wavelengths")).of(Affects::picture);
    parameters.add(presence("dark", dark, "no light at all"));
    parameters.add(parameter("shard", shard, "share of the work")).of(Affects::share);
  }
  Fields& take(const char* name, const Texts& texts) {
    parameters.find(name)->take(texts);
    return *this;
  }
  Recipe recipe() const { return recipe_of(parameters); }
  std::string text() const { return text_of(recipe()); }
};

std::string refusal_of(const std::string& text) {
  try {
    recipe_in(text, "a.toml");
  } catch (const algebra::Error& error) {
    return error.what();
  }
  return "";
}

TEST(Recipe, HoldsAllButWhatThisRunDoesAndWhatHasNoValue) {
  EXPECT_EQ(Fields().take("shard", {"1/2"}).text(), "dust = 0\nseed = 1\nalbedo-map = 'auto'\n");
}

TEST(Recipe, SpellsNumbersAlikeAndTextsAsTheyAre) {
  Fields fields;
  fields.take("dust", {".5e-6"}).take("seed", {"18446744073709551615"});
  fields.take("albedo-map", {"007"}).take("dark", {"true"});
  EXPECT_EQ(fields.text(),
            "dust = 5e-07\nseed = '18446744073709551615'\nalbedo-map = '007'\ndark = true\n");
}

TEST(Recipe, NamesFilesWithoutTheFoldersOfTheUser) {
  Fields fields;
  fields.take("albedo-map", {"/home/alice/maps/moon.tif"});
  EXPECT_EQ(setting_in(fields.recipe(), "albedo-map")->texts, Texts{"moon.tif"});
}

TEST(Recipe, IsReadAsItWasWritten) {
  Fields fields;
  fields.take("dust", {"0.1"}).take("albedo-map", {"it's \"a\"\nmap\\.png"});
  for (const Texts& waves : {Texts{"1.5"}, Texts{"1.5", "2"}}) {
    const auto recipe = fields.take("waves", waves).recipe();
    EXPECT_TRUE(differences(recipe_in(text_of(recipe)), recipe).empty()) << text_of(recipe);
    EXPECT_EQ(setting_in(recipe_in(text_of(recipe)), "waves")->texts, waves);
  }
}

constexpr const char* plume =
    "rays = 50\n\n[atmosphere]\nmodel = 'clear'\nozone-du = 300\n\n[[atmosphere.region]]\n"
    "from-latitude = -90\nto-latitude = 0\n";

TEST(Recipe, HasTheParametersOfATableByTheirOwnNames) {
  const auto recipe = recipe_in(plume, "a.toml");
  const auto* model = setting_in(recipe, "atmosphere");
  ASSERT_NE(model, nullptr);
  EXPECT_EQ(model->texts, Texts{"clear"});
  EXPECT_EQ(model->where, "a.toml:4: ");
  EXPECT_EQ(setting_in(recipe, "ozone-du")->table, "atmosphere");
  const auto& regions = setting_in(recipe, "region")->parts;
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_EQ(setting_in(regions[0], "from-latitude")->texts, Texts{"-90"});
}

TEST(Recipe, NamesFileAndLineOfWhatItCannotRead) {
  EXPECT_TRUE(refusal_of("rays = 5\nseed = \n").starts_with("a.toml:2: "));
  EXPECT_EQ(refusal_of("ozone-du = 300\n[atmosphere]\nozone-du = 200\n"),
            "a.toml:3: ozone-du: given twice, above all tables and in [atmosphere]");
  EXPECT_EQ(refusal_of("\nmap = \"a\\u0000b\"\n"),
            "a.toml:2: map: holds a zero byte, allowed is text without");
  EXPECT_NE(refusal_of("x = 1\n" + std::string(99, '.')), "");
  EXPECT_EQ(refusal_of(std::string((1 << 20) + 1, '\n')),
            "a.toml: a recipe of more than 1048576 bytes, allowed up to that");
}

/// What films of earlier versions keep of their light has texts without quotes.
TEST(Recipe, MayBeginWithTextsWithoutQuotes) {
  const auto recipe = recipe_in("version = 1.6.0\nmap-contents = a b\ndust = 1\n", "",
                                {"version", "map-contents", "first-frame"});
  EXPECT_EQ(setting_in(recipe, "version")->texts, Texts{"1.6.0"});
  EXPECT_EQ(setting_in(recipe, "map-contents")->texts, Texts{"a b"});
  EXPECT_EQ(setting_in(recipe, "dust")->texts, Texts{"1"});
  EXPECT_FALSE(setting_in(recipe, "first-frame")->has_value());
}

TEST(RecipeWith, HasValuesInPlaceOfItsOwn) {
  const auto asked = Fields().recipe();
  const auto made = with({{.name = "seed", .texts = {"7"}, .bare = true}}, asked);
  EXPECT_EQ(text_of(made), "seed = 7\ndust = 0\nalbedo-map = 'auto'\n");
  EXPECT_EQ(setting_in(made, "seed")->affects, Affects::light) << "as the request says";
}

TEST(Differences, AreOfValuesAndNotOfHowTheyAreSpelt) {
  const auto asked = Fields().recipe();
  EXPECT_TRUE(
      differences(recipe_in("seed = 1.0\nalbedo-map = \"auto\"\ndust = '0'\n"), asked).empty());
  const auto found = differences(recipe_in("seed = 2\nold = 'x'\n"), asked);
  ASSERT_EQ(found.size(), 4U);
  EXPECT_EQ(found[0].name + found[0].first + found[0].second, "old'x'none");
  EXPECT_EQ(found[1].name + found[1].first + found[1].second, "seed21");
  EXPECT_EQ(found[2].name + found[2].first + found[2].second, "dustnone0");
}

TEST(Differences, CountByWhatTheSecondSaysThatTheyAffect) {
  Fields fields;
  const auto asked = fields.take("waves", {"5"}).recipe();
  const auto found =
      differences(recipe_in("seed = 2\nwaves = '6'\n"), asked,
                  [](const Setting& setting) { return setting.affects > Affects::light; });
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].name, "waves");
}

TEST(Differences, OfPartsLookAtThePartsInAnyOrder) {
  const std::string head = "[[atmosphere.region]]\n", edges[] = {"a = 1\n", "b = 2\n"};
  const auto one = recipe_in(head + edges[0] + edges[1]);
  EXPECT_TRUE(differences(one, recipe_in(head + edges[1] + edges[0])).empty());
  const auto found = differences(one, recipe_in(head + edges[1]));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(found[0].of_parts);
  EXPECT_EQ(found[0].first, "a = 1; b = 2");
}

}  // namespace coppermoon::request::recipe_test
