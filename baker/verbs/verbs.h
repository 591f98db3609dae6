// SPDX-License-Identifier: MIT
#pragma once

#include "verbs/flags.h"

namespace coppermoon::verbs {

/// Each adds one word to the command line: its flags, and what it does once they are read.
/// What it does throws algebra::Error when it cannot, WrongUsage when the usage is wrong.
void add_almanac(CLI::App& program);
void add_sky(CLI::App& program);
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

}  // namespace coppermoon::verbs
