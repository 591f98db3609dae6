// SPDX-License-Identifier: MIT
#pragma once

#include <tbb/global_control.h>

#include <memory>
#include <string>
#include <vector>

#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Each adds one word to the command line: its flags, and what it does once they are read.
/// What it does throws algebra::Error when it cannot, WrongUsage when the usage is wrong.
void add_almanac(CLI::App& program);
void add_sky(CLI::App& program);
void add_night(CLI::App& program);
void add_explore(CLI::App& program);
void add_plan(CLI::App& program);
void add_shadow(CLI::App& program);
void add_brightness(CLI::App& program);
void add_bake(CLI::App& program);
void add_ring(CLI::App& program);
void add_scene(CLI::App& program);
void add_still(CLI::App& program);
void add_animate(CLI::App& program);
void add_develop(CLI::App& program);
void add_merge(CLI::App& program);
void add_compare(CLI::App& program);
void add_fit(CLI::App& program);
void add_tradeoff(CLI::App& program);

/// All words of the command line, each with its flags.
void add_words(CLI::App& program);

/// --threads of every command, once all are added.
///
/// Given  control  holds the number of threads of all that follows; none: one for each processor
void add_threads(CLI::App& program, std::unique_ptr<tbb::global_control>& control);

/// Reads a command line, recipes put in, and does what it says.
///
/// Given   arguments  without the program's name
/// Throws  WrongUsage       when the usage is wrong: also for an argument that is not UTF-8, which
///                          neither a recipe nor JSON could hold
///         CLI::ParseError  when CLI11 finds it wrong, or for help
///         algebra::Error   when it cannot be done
void run(CLI::App& program, const std::vector<std::string>& arguments);

}  // namespace coppermoon::verbs
