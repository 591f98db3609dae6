// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <vector>

#include "fuzz/refused.h"
#include "fuzz/scratch_file.h"
#include "verbs/command_line.h"
#include "verbs/one_line.h"
#include "verbs/recipe.h"

namespace coppermoon::fuzz {

using Words = std::vector<std::string>;

/// The program, whose words are read and not done; any number of command lines one after another.
struct SilentProgram {
  struct Understood {};
  CLI::App app{"", "coppermoon"};

  SilentProgram() {
    verbs::add_words(app);
    app.parse_complete_callback([] { throw Understood(); });
  }

  /// Whether the words can be understood.
  bool understands(const Words& words) {
    try {
      done([&] { verbs::obey(app, words); });
    } catch (const Understood&) {
      return true;
    } catch (const CLI::ParseError& error) {
      require(error.get_exit_code() == 0 || !verbs::one_line(error.what()).empty());
    }
    return false;
  }
};

/// The recipe of a texture's command line that was understood, read in its place, makes the same one;
/// empty values, which the words would refuse later, no recipe has.
inline void require_lasting_recipe(const Words& words) {
  const auto empty = [](const auto& word) { return word.empty() || word.ends_with('='); };
  static SilentProgram first, second;
  if (!first.understands(words)) return;
  const auto* verb = first.app.get_subcommands().at(0);
  if (verb->get_option_no_throw("--photometry") == nullptr || std::ranges::any_of(words, empty))
    return;
  std::string recipe;
  if (!done([&] { recipe = verbs::recipe_of(*verb); })) return;
  static const ScratchFile file("lasting.toml");
  Words again{verb->get_name(), "--recipe", file.holding(recipe).string()};
  if (verb->get_option_no_throw("--output") != nullptr) again.push_back("--output=a");
  require(second.understands(again));
  require(verbs::recipe_of(*second.app.get_subcommands().at(0)) == recipe);
}

}  // namespace coppermoon::fuzz
