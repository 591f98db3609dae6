// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Each of these functions adds one command to the program: its parameters, and the function that runs once they have
/// their values. That function throws algebra::Error if it fails, and WrongUsage if the usage is wrong.
void add_almanac(Program& program);
void add_sky(Program& program);
void add_night(Program& program);
void add_explore(Program& program);
void add_plan(Program& program);
void add_shadow(Program& program);
void add_shader(Program& program);
void add_brightness(Program& program);
void add_bake(Program& program);
void add_ring(Program& program);
void add_dome(Program& program);
void add_scene(Program& program);
void add_still(Program& program);
void add_animate(Program& program);
void add_develop(Program& program);
void add_merge(Program& program);
void add_compare(Program& program);
void add_fit(Program& program);
void add_tradeoff(Program& program);
void add_describe(Program& program);
void add_cache(Program& program);

/// Adds all commands.
void add_verbs(Program& program);

/// What a command line asks for: a command to run, or a text to print, such as help.
struct Asked {
  Verb* verb = nullptr;
  std::string text{};  ///< printed instead of running the command, unless empty
};

/// Command that a command line asks for, with its parameters set. Values from a recipe are taken first: from the file
/// that --recipe names, or from a file made by coppermoon that stands in the place of the instant.
///
/// Given   words  the command line without the program's name
/// Throws  WrongUsage      for an unknown command, option or word: names the nearest known one; for an argument that
///                         is not UTF-8, which neither a recipe nor JSON could hold
///         algebra::Error  for a value that is not allowed; if a recipe cannot be read
Asked asked_by(Program& program, std::vector<std::string> words);

/// Sets a command's parameters from the words that follow its name on the command line.
///
/// Throws  as asked_by
void take(Verb& verb, const std::vector<std::string>& words);

/// Runs a command whose parameters have their values, after checking that its files are distinct
/// (require_files_apart). Says on stderr how it understands values that are ambiguous.
void run(Verb& verb);

}  // namespace coppermoon::verbs
