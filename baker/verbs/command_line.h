// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Each of these functions adds one command to the program: its parameters, and the function that runs it once its
/// parameters are set. Running a command throws WrongUsage if it is used wrongly, and algebra::Error if it fails.
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

/// Adds all of these commands to the program.
void add_verbs(Program& program);

/// What a command line asks the program to do: run a command, or print text such as help.
struct Asked {
  Verb* verb = nullptr;
  std::string text{};  ///< if not empty, printed instead of running the command
};

/// Reads a command line, and sets the parameters of the command that it names. If there is a recipe, its values are set
/// too. The recipe is the file that --recipe names, or a file made by coppermoon that is named in place of the instant.
///
/// Given   words  the command line without the program's name
/// Throws  WrongUsage      for an unknown command, option or word (the message suggests the nearest known one); for an
///                         argument that is not UTF-8, because neither a recipe nor JSON could hold it
///         algebra::Error  for a value that is not allowed, or a recipe that cannot be read
Asked asked_by(Program& program, std::vector<std::string> words);

/// Sets a command's parameters from the words that follow its name on the command line.
///
/// Throws  the same errors as asked_by
void take(Verb& verb, const std::vector<std::string>& words);

/// Runs a command whose parameters are set, after checking that none of its files would overwrite another
/// (require_files_apart). Reports on stderr how ambiguous values are interpreted.
void run(Verb& verb);

}  // namespace coppermoon::verbs
