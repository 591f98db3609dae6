// SPDX-License-Identifier: MIT
// The sweep's recipes draw every key that there is, or tell why not.
#include <nlohmann/json.hpp>

#include "extremes/random_recipe.h"
#include "support/program.h"

namespace coppermoon::extremes::random_recipes_test {

class RandomRecipesTest : public ProgramTest {
 protected:
  const RandomRecipes recipes{nlohmann::json::parse(coppermoon("describe --json").out)};

  std::set<std::string> names_of(const char* command) const {
    std::set<std::string> names;
    for (const auto& parameter : recipes.parameters(command)) {
      if (!parameter.at("recipe").get<bool>()) continue;
      names.insert(parameter.at("name"));
      if (parameter.contains("parts"))
        for (const auto& part : parameter.at("parts"))
          names.insert("region." + part.at("name").get<std::string>());
    }
    return names;
  }
};

TEST_F(RandomRecipesTest, DrawEachKeyOfEachCommandOrSayWhyNot) {
  std::map<std::string, std::set<std::string>> drawn;
  for (std::uint64_t i = 0; i < 10000; ++i) {
    const auto made = recipes.recipe(1, i);
    drawn[made.command.name].insert(made.keys.begin(), made.keys.end());
  }
  for (const auto& command : commands)
    for (const auto& name : names_of(command.name)) {
      EXPECT_TRUE(drawn[command.name].contains(name) || keys_left_out().contains(name))
          << command.name << ": " << name
          << " has neither words nor a range: give it values in tests/extremes/random_recipe.h, or "
             "the reason why none is drawn";
    }
}

TEST_F(RandomRecipesTest, NameNoKeyThatThereIsNot) {
  std::set<std::string> known;
  for (const auto& command : commands) known.merge(names_of(command.name));
  for (const auto& [key, value] : values_by_hand()) EXPECT_TRUE(known.contains(key)) << key;
  for (const auto& [key, reason] : keys_left_out()) EXPECT_TRUE(known.contains(key)) << key;
}

TEST_F(RandomRecipesTest, AreTheSameEachTime) {
  for (std::uint64_t i = 0; i < 100; ++i)
    EXPECT_EQ(recipes.recipe(1, i).text, recipes.recipe(1, i).text);
}

}  // namespace coppermoon::extremes::random_recipes_test
