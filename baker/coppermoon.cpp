// SPDX-License-Identifier: MIT
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>
#include <memory>

#include "algebra/error.h"
#include "verbs/recipe.h"
#include "verbs/verbs.h"

namespace {

namespace verbs = coppermoon::verbs;

constexpr int could_not = 1, wrong_usage = 2;

void add_words(CLI::App& program) {
  program.option_defaults()->always_capture_default()->multi_option_policy(
      CLI::MultiOptionPolicy::TakeLast);
  program.require_subcommand(1);
  program.set_version_flag("--version", "coppermoon " COPPERMOON_VERSION);
  for (const auto add :
       {verbs::add_almanac, verbs::add_sky, verbs::add_plan, verbs::add_shadow,
        verbs::add_brightness, verbs::add_bake, verbs::add_scene, verbs::add_still,
        verbs::add_develop, verbs::add_tradeoff})
    add(program);
}

/// Threads of all that follows; 0: as many as there are processors.
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
            "0: as many as there are processors")
        ->check(CLI::Range(0, 512));
}

/// The first line of an error, whoever wrote it.
std::string one_line(std::string text) { return text.substr(0, text.find('\n')); }

int run(CLI::App& program, int count, char** words) {
  try {
    auto arguments = verbs::with_recipes(program, {words + 1, words + count});
    std::reverse(arguments.begin(), arguments.end());  // as CLI11 takes them
    program.parse(arguments);
    return 0;
  } catch (const CLI::CallForHelp& call) {
    return program.exit(call);
  } catch (const CLI::CallForVersion& call) {
    return program.exit(call);
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "coppermoon: {}\n", one_line(error.what()));
    return wrong_usage;
  } catch (const std::exception& error) {
    fmt::print(stderr, "coppermoon: {}\n", one_line(error.what()));
    return could_not;
  }
}

}  // namespace

int main(int count, char** words) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file too large is an error like any other, said in one line
  CLI::App program{"coppermoon bakes eclipsed Moons", "coppermoon"};
  std::unique_ptr<tbb::global_control> threads;
  add_words(program);
  add_threads(program, threads);
  return run(program, count, words);
}
