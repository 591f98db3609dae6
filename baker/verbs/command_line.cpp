// SPDX-License-Identifier: MIT
#include "verbs/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "uses/light/header.h"
#include "verbs/flags/known_words.h"
#include "verbs/flags/moments.h"
#include "verbs/flags/verb.h"
#include "verbs/recipes/recipe.h"
#include "verbs/reports/one_line.h"

namespace coppermoon::verbs {

void add_words(CLI::App& program) {
  program.option_defaults()->always_capture_default()->multi_option_policy(
      CLI::MultiOptionPolicy::TakeLast);
  program.require_subcommand(1);
  program.set_version_flag("--version", fmt::format("coppermoon {}", uses::version()));
  for (const auto add :
       {add_almanac, add_night, add_explore, add_sky,    add_plan,     add_shadow,   add_brightness,
        add_bake,    add_ring,  add_dome,    add_shader, add_scene,    add_still,    add_animate,
        add_develop, add_merge, add_compare, add_fit,    add_tradeoff, add_describe, add_cache})
    add(program);
  program.set_help_flag("-h,--help", "lists the commands");
  program.set_help_all_flag("--help-all", "lists the commands");
  for (auto* verb : program.get_subcommands({})) {
    verb->set_help_flag("-h,--help", "explains the command, with its common options");
    verb->set_help_all_flag("--help-all", "explains the command, with all its options");
  }
}

void add_threads(CLI::App& program, std::unique_ptr<tbb::global_control>& control) {
  for (auto* verb : program.get_subcommands({}))
    verb->add_option_function<int>(
            "--threads",
            [&control](int threads) {
              if (threads > 0)
                control = std::make_unique<tbb::global_control>(
                    tbb::global_control::max_allowed_parallelism,
                    static_cast<std::size_t>(threads));
            },
            "number of threads; 0: one for each processor")
        ->check(CLI::Range(0, 512));
}

namespace {

/// "help still" as "still --help", "version" as "--version".
std::vector<std::string> with_words_as_flags(std::vector<std::string> arguments) {
  const auto word = arguments.empty() ? "" : arguments.front();
  if (word != "help" && word != "version") return arguments;
  arguments.erase(arguments.begin());
  arguments.push_back("--" + word);
  return arguments;
}

std::vector<std::string> flags_named_in(const std::vector<std::string>& arguments) {
  std::vector<std::string> names;
  for (const auto& argument : arguments)
    if (argument.starts_with("--")) names.push_back(argument.substr(2, argument.find('=') - 2));
  return names;
}

}  // namespace

void run(CLI::App& program, const std::vector<std::string>& typed) {
  for (const auto& argument : typed)
    if (!is_utf8(argument))
      throw WrongUsage(fmt::format("argument '{}', allowed is UTF-8", argument));
  const auto arguments = with_moments_joined(with_words_as_flags(typed));
  for (auto* verb : program.get_subcommands({}))
    dynamic_cast<Verb&>(*verb).typed = flags_named_in(arguments);
  auto all = with_recipes(program, arguments);
  if (const auto recipe = recipe_named_in(program, arguments); !recipe.empty())
    all.push_back("--recipe=" + recipe);  // a file like others that are read
  std::reverse(all.begin(), all.end());   // as CLI11 takes them
  program.parse(std::move(all));
}

}  // namespace coppermoon::verbs
