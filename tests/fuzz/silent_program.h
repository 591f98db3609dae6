// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "fuzz/refused.h"
#include "fuzz/scratch_file.h"
#include "verbs/command_line.h"
#include "verbs/flags/flags.h"
#include "verbs/recipes/recipe.h"
#include "verbs/reports/one_line.h"

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

  /// Whether the words can be understood; all that earlier words gave is forgotten.
  bool understands(const Words& words) {
    for (auto* verb : app.get_subcommands({}))
      for (auto& parameter : verbs::parameters_of(*verb)) parameter.reset();
    try {
      done([&] { verbs::run(app, words); });
    } catch (const Understood&) {
      return true;
    } catch (const CLI::ParseError& error) {
      require(error.get_exit_code() == 0 || !verbs::one_line(error.what()).empty());
    } catch (const verbs::WrongUsage& error) {
      require(!verbs::one_line(error.what()).empty());
    }
    return false;
  }
};

/// A program for thousands of command lines, which takes less time than one for each; then a new one,
/// for CLI11 keeps the order of all options that it ever read.
class RenewedProgram {
 public:
  SilentProgram& operator()() {
    constexpr int lines = 10000;
    if (count_++ % lines == 0) program_ = std::make_unique<SilentProgram>();
    return *program_;
  }

 private:
  int count_ = 0;
  std::unique_ptr<SilentProgram> program_;
};

/// The recipe of a texture's command line that was understood, read in its place, makes the same one;
/// empty values, which the words would refuse later, no recipe has.
inline void require_lasting_recipe(const Words& words) {
  const auto empty = [](const auto& word) { return word.empty() || word.ends_with('='); };
  static RenewedProgram programs, others;
  auto& first = programs();
  if (!first.understands(words)) return;
  const auto* verb = first.app.get_subcommands().at(0);
  if (verb->get_option_no_throw("--photometry") == nullptr || std::ranges::any_of(words, empty))
    return;
  std::string recipe;
  if (!done([&] { recipe = verbs::recipe_of(*verb); })) return;
  static const ScratchFile file("lasting.toml");
  Words again{verb->get_name(), "--recipe", file.holding(recipe).string()};
  if (verb->get_option_no_throw("--output") != nullptr) again.push_back("--output=a");
  auto& second = others();
  require(second.understands(again));
  require(verbs::recipe_of(*second.app.get_subcommands().at(0)) == recipe);
}

}  // namespace coppermoon::fuzz
