// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "fuzz/refused.h"
#include "fuzz/scratch_file.h"
#include "verbs/command_line.h"
#include "verbs/flags/flags.h"
#include "verbs/reports/one_line.h"

namespace coppermoon::fuzz {

using Words = std::vector<std::string>;

/// The program, whose command lines are read and not run, one after another.
struct SilentProgram : verbs::Program {
  SilentProgram() { add_verbs(*this); }

  /// Command of words that can be understood, else null; all that earlier words gave is forgotten.
  verbs::Verb* understood(const Words& words) {
    for (auto& verb : verbs)
      for (auto& parameter : verb.parameters) parameter.reset();
    for (auto& parameter : of_all) parameter.reset();
    verbs::Asked asked;
    try {
      if (!done([&] { asked = asked_by(*this, words); })) return nullptr;
    } catch (const verbs::WrongUsage& error) {
      require(!verbs::one_line(error.what()).empty());
    }
    return asked.text.empty() ? asked.verb : nullptr;
  }
};

/// The recipe of a texture's command line that was understood, read in its place, makes the same one;
/// empty values, which the words would refuse later, no recipe has.
inline void require_lasting_recipe(const Words& words) {
  const auto empty = [](const auto& word) { return word.empty() || word.ends_with('='); };
  static SilentProgram first, second;
  const auto* verb = first.understood(words);
  if (verb == nullptr || verb->parameters.find("photometry") == nullptr ||
      std::ranges::any_of(words, empty))
    return;
  std::string recipe;
  if (!done([&] { recipe = verbs::recipe_of(*verb); })) return;
  static const ScratchFile file("lasting.toml");
  Words again{verb->name, "--recipe", file.holding(recipe).string()};
  if (verb->parameters.find("output") != nullptr) again.push_back("--output=a");
  const auto* same = second.understood(again);
  require(same != nullptr);
  require(verbs::recipe_of(*same) == recipe);
}

}  // namespace coppermoon::fuzz
