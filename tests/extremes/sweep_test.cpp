// SPDX-License-Identifier: MIT
// Ten thousand random recipes over all that may be asked for, and a little beyond: every one ends in a valid file or in
// one clear line. A hundred tests of 100 each.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "extremes/random_recipe.h"
#include "extremes/tried.h"
#include "support/program.h"
#include "texture/read_image.h"

namespace coppermoon::extremes::sweep_test {

namespace fs = std::filesystem;

constexpr std::uint64_t seed = 10000, recipes_a_test = 100;

/// Recipes of all that the program says may be asked for.
const RandomRecipes& recipes() {
  static const RandomRecipes all = [] {
    const ProgramFolder folder;
    return RandomRecipes(nlohmann::json::parse(folder.coppermoon("describe --json").out));
  }();
  return all;
}

class Sweep : public ProgramTest, public testing::WithParamInterface<int> {
 protected:
  Outcome made(const RandomRecipe& recipe) const {
    file("recipe.toml", recipe.text);
    Words words{"timeout",           "600",      COPPERMOON_PROGRAM,
                recipe.command.name, "--recipe", "recipe.toml"};
    if (*recipe.command.output != 0)
      words += Words{"-o", recipe.command.output};
    else
      words.emplace_back("--json");
    return run(words, {.processor_limit = 120});
  }

  /// What is wrong with what was made; empty when nothing is.
  std::string flaw_of_file(const Command& command, const Outcome& outcome) const {
    if (*command.output == 0) return nlohmann::json::accept(outcome.out) ? "" : "no JSON";
    const auto at = here(command.output);
    if (fs::is_directory(at)) {
      const bool for_povray = fs::exists(at / "eclipse.pov") && fs::exists(at / "eclipse.ini"),
                 for_mitsuba = fs::exists(at / "eclipse.xml") && fs::exists(at / "moon.obj");
      return for_povray || for_mitsuba ? flaw_of_image(at / "moon_lin_rec709.exr")
                                       : "an empty folder";
    }
    return flaw_of_image(at);
  }

  static std::string flaw_of_image(const fs::path& path) {
    const auto image = texture::read_image(path);
    const bool finite = std::ranges::all_of(image.values, [](float v) { return std::isfinite(v); });
    return finite && !image.values.empty() ? "" : "values that are no numbers";
  }

  /// Standard error without the warnings that a sound recipe may have.
  static std::string without_warnings(const std::string& err) {
    std::istringstream lines(err);
    std::string rest;
    for (std::string line; std::getline(lines, line);) {
      const auto has = [&](const char* words) { return line.find(words) != std::string::npos; };
      if (!has("the tolerance cannot be reached") && !has(": no effect ") &&
          !has("the budget is too short for any light") &&
          !has("on Danjon's scale; the nearest is taken") &&
          !has("times as bright as the Moon, which hardly shows") &&
          !has("the Moon cannot be seen in its sky"))
        rest += line + '\n';
    }
    return rest;
  }

  std::string flaw_of_refusal(const Outcome& outcome) const {
    if (outcome.status != 1 && outcome.status != 2) return fmt::format("status {}", outcome.status);
    const auto said = without_warnings(outcome.err);
    if (!said.starts_with("coppermoon: ") || std::ranges::count(said, '\n') != 1)
      return "not one line";
    return listing() == std::set<std::string>{"here/recipe.toml"} ? "" : "something is left";
  }

  /// Nothing but the recipe and the output, neither of them another's.
  std::string flaw_of_folder(const RandomRecipe& recipe) const {
    if (text_of(here("recipe.toml")) != recipe.text) return "the recipe is another";
    const auto output = std::string("here/") + recipe.command.output;
    for (const auto& name : listing())
      if (name != "here/recipe.toml" && name != output && !name.starts_with(output + "/"))
        return name + " is left";
    return "";
  }

  void tidy(const Command& command) const {
    if (*command.output != 0) fs::remove_all(here(command.output));
  }
};

TEST_P(Sweep, EndsInAValidFileOrOneLine) {
  int files = 0, lines = 0;
  double most_mb = 0;
  const auto first = static_cast<std::uint64_t>(GetParam()) * recipes_a_test;
  for (std::uint64_t i = first; i < first + recipes_a_test; ++i) {
    const auto recipe = recipes().recipe(seed, i);
    const auto outcome = made(recipe);
    const bool done = outcome.status == 0;
    auto flaw = done ? flaw_of_file(recipe.command, outcome) : flaw_of_refusal(outcome);
    if (done && flaw.empty()) flaw = flaw_of_folder(recipe);
    if (done && !without_warnings(outcome.err).empty()) flaw = "done, with a complaint";
    EXPECT_EQ(flaw, "") << "seed " << seed << ", recipe " << i << ": " << recipe.command.name
                        << "\n"
                        << recipe.text << outcome.err;
    EXPECT_LT(outcome.most_memory_mb, 4000)
        << "400 bands on 9 planes, all kept, take 3700: " << seed << ", " << i << "\n"
        << recipe.text;
    most_mb = std::max(most_mb, outcome.most_memory_mb);
    if (flaw.empty()) ++(done ? files : lines);
    tidy(recipe.command);
  }
  EXPECT_GT(files, 28) << "47 in 100 are valid: so few by chance once in ten thousand";
  tried(fmt::format("random recipes {} to {}", first, first + recipes_a_test - 1),
        fmt::format("{} valid files, {} refused in one line, {:.0f} MB", files, lines, most_mb));
}

INSTANTIATE_TEST_SUITE_P(TenThousand, Sweep, testing::Range(0, 100));

}  // namespace coppermoon::extremes::sweep_test
