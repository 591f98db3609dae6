// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Each adds one command to the program: its parameters, and what runs once they have their values, which throws
/// algebra::Error when it cannot be done, WrongUsage when the usage is wrong.
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

/// What a command line asks for: a command, or a text, as help.
struct Asked {
  Verb* verb = nullptr;
  std::string text{};  ///< to be printed in place of a run; empty: none
};

/// Command that a line asks for, its parameters with the line's values. Those that a recipe has are taken first, of the
/// file of --recipe, or of coppermoon's own in the instant's place.
///
/// Given   words  without the program's name
/// Throws  WrongUsage      for a command, an option or a value there is not: names the nearest there is; for an
///                         argument that is not UTF-8, which neither a recipe nor JSON could hold
///         algebra::Error  for a value that is not allowed; when a recipe cannot be read
Asked asked_by(Program& program, std::vector<std::string> words);

/// Gives a command the values of its line, which begins behind the command's name.
///
/// Throws  as asked_by
void take(Verb& verb, const std::vector<std::string>& words);

/// Runs a command whose parameters have their values, when its files are known to be apart (require_files_apart); says
/// on stderr what is meant where something is not clear.
void run(Verb& verb);

}  // namespace coppermoon::verbs
