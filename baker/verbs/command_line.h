// SPDX-License-Identifier: MIT
#pragma once

#include <tbb/global_control.h>

#include <memory>
#include <string>
#include <vector>

#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Each adds one command to the program: its flags, and what runs once they are read, which throws algebra::Error when
/// it cannot be done, WrongUsage when the usage is wrong.
void add_almanac(CLI::App& program);
void add_sky(CLI::App& program);
void add_night(CLI::App& program);
void add_explore(CLI::App& program);
void add_plan(CLI::App& program);
void add_shadow(CLI::App& program);
void add_shader(CLI::App& program);
void add_brightness(CLI::App& program);
void add_bake(CLI::App& program);
void add_ring(CLI::App& program);
void add_dome(CLI::App& program);
void add_scene(CLI::App& program);
void add_still(CLI::App& program);
void add_animate(CLI::App& program);
void add_develop(CLI::App& program);
void add_merge(CLI::App& program);
void add_compare(CLI::App& program);
void add_fit(CLI::App& program);
void add_tradeoff(CLI::App& program);
void add_describe(CLI::App& program);
void add_cache(CLI::App& program);

/// Adds all commands, each with its flags.
void add_words(CLI::App& program);

/// Adds --threads to every command that there is.
///
/// Given  control  holds the number of threads of all that follows; none: one for each processor
void add_threads(CLI::App& program, std::unique_ptr<tbb::global_control>& control);

/// Reads a command line with its recipe, and runs its command.
///
/// Given   arguments  without the program's name
/// Throws  WrongUsage       when the usage is wrong: also for an argument that is not UTF-8, which
///                          neither a recipe nor JSON could hold
///         CLI::ParseError  when CLI11 rejects the arguments, or help is asked for
///         algebra::Error   when the command fails
void run(CLI::App& program, const std::vector<std::string>& arguments);

}  // namespace coppermoon::verbs
