// SPDX-License-Identifier: MIT
#include "verbs/recipes/recipe.h"

#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <sstream>

#include "request/recipe.h"
#include "verbs/flags/known_words.h"
#include "verbs/flags/named_files.h"
#include "verbs/recipes/recipe_file.h"

namespace coppermoon::verbs {
namespace {

std::vector<std::string> words_of(const CLI::App& program) {
  std::vector<std::string> words;
  for (const auto* verb : program.get_subcommands({})) words.push_back(verb->get_name());
  return words;
}

const CLI::App& verb_named(const CLI::App& program, const std::string& name) {
  for (const auto* verb : program.get_subcommands({}))
    if (verb->get_name() == name) return *verb;
  const auto suggestion = verb_suggested_for(name, words_of(program));
  throw WrongUsage(
      fmt::format("{}: unknown command{}", name,
                  suggestion.empty() ? "; `coppermoon --help` lists the commands" : suggestion));
}

/// Takes `--recipe FILE` or `--recipe=FILE` out of the arguments.
std::string taken_recipe(std::vector<std::string>& arguments) {
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    std::string path;
    if (arguments[i].starts_with("--recipe="))
      path = arguments[i].substr(9);
    else if (arguments[i] == "--recipe" && i + 1 < arguments.size()) {
      path = arguments[i + 1];
      arguments.erase(arguments.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      continue;
    }
    arguments.erase(arguments.begin() + static_cast<std::ptrdiff_t>(i));
    return path;
  }
  return {};
}

/// Refuses -o of a command that has none, and names its flags of files.
void require_no_output(const CLI::App& verb, const std::string& argument) {
  if (!argument.starts_with("-o") || verb.get_option_no_throw("-o") != nullptr) return;
  std::vector<std::string> flags;
  for (const auto* option : verb.get_options())
    if (says_where_results_go(*option)) flags.push_back("--" + option->get_lnames().front());
  throw WrongUsage(fmt::format("-o: unknown option of {}; {}", verb.get_name(),
                               flags.empty()
                                   ? "it prints its results"
                                   : fmt::format("files are named by {}", fmt::join(flags, ", "))));
}

/// Advice that ends the error of an unknown flag.
std::string way_out_for(const std::string& flag, const CLI::App& verb,
                        const std::vector<std::string>& known) {
  if (flag == "verbose" || flag == "progress")
    return "; progress is shown wherever the output is a terminal";
  if (flag == "quiet") return "; 2>/dev/null hides what is said beside the results";
  const auto suggestion = flag_suggested_for(flag, known);
  return suggestion.empty()
             ? fmt::format("; `coppermoon {} --help-all` lists them", verb.get_name())
             : suggestion;
}

void require_flags(const CLI::App& verb, const std::vector<std::string>& arguments) {
  const auto known = long_flags(verb);
  for (const auto& argument : arguments) {
    require_no_output(verb, argument);
    if (!argument.starts_with("--") || argument.size() == 2) continue;
    const auto flag = argument.substr(2, argument.find('=') - 2);
    if (!holds(known, flag))
      throw WrongUsage(fmt::format("--{}: unknown option of {}{}", flag, verb.get_name(),
                                   way_out_for(flag, verb, known)));
    if (argument.size() == flag.size() + 3)  // else the next word would be taken
      throw WrongUsage(fmt::format("--{}: a value is missing behind the =", flag));
  }
}

/// First argument that is neither a flag nor a flag's value.
std::vector<std::string>::iterator positional(const CLI::App& verb,
                                              std::vector<std::string>& arguments) {
  for (auto argument = arguments.begin(); argument != arguments.end(); ++argument) {
    const bool flag =
        argument->size() > 1 && argument->front() == '-' && !std::isdigit((*argument)[1]);
    if (!flag) return argument;
    const auto* option = verb.get_option_no_throw(*argument);
    const bool value_follows = option != nullptr && option->get_items_expected_max() > 0;
    if (value_follows && argument + 1 != arguments.end()) ++argument;
  }
  return arguments.end();
}

/// Flag whose name may be left out, as --instant; empty: none.
std::string flag_of_positional(const CLI::App& verb) {
  for (const auto* option : verb.get_options())
    if (option->get_positional() && !option->get_lnames().empty())
      return "--" + option->get_lnames().front();
  return {};
}

/// Arguments of a command, apart from its recipe.
struct Arguments {
  std::string recipe;
  std::vector<std::string> mine;
};

Arguments apart(const CLI::App& verb, std::vector<std::string> mine) {
  std::string path = taken_recipe(mine);
  if (!taken_recipe(mine).empty()) throw WrongUsage("--recipe: given twice, allowed once");
  const std::string flag = flag_of_positional(verb);
  if (const auto own = positional(verb, mine); own != mine.end() && !flag.empty()) {
    if (path.empty() && (flag == "--instant" || flag == "--eclipse") && holds_recipe(*own)) {
      path = *own;
      mine.erase(own);
    } else if (!path.empty()) {
      *own = flag + "=" + *own;
    }
  }
  return {path, mine};
}

/// Flags of the recipe, then the user's own, which win.
std::vector<std::string> with_recipe(const CLI::App& verb, std::vector<std::string> all) {
  const auto [path, mine] = apart(verb, std::move(all));
  if (path.empty()) return mine;
  auto arguments = flags_of_recipe(verb, path, mine);
  arguments.insert(arguments.end(), mine.begin(), mine.end());
  return arguments;
}

/// First argument that is no flag: the command.
auto word_in(const std::vector<std::string>& arguments) {
  return std::find_if(arguments.begin(), arguments.end(),
                      [](const auto& a) { return !a.starts_with("-"); });
}

}  // namespace

std::vector<std::string> with_recipes(const CLI::App& program,
                                      const std::vector<std::string>& arguments) {
  const auto word = word_in(arguments);
  if (word == arguments.end() && arguments.empty())
    throw WrongUsage(fmt::format("a command is required: {}; `coppermoon --help` explains them",
                                 fmt::join(words_of(program), ", ")));
  if (word == arguments.end()) return arguments;
  const CLI::App& verb = verb_named(program, *word);
  const std::vector<std::string> mine(word + 1, arguments.cend());
  require_flags(verb, mine);
  std::vector<std::string> all(arguments.cbegin(), word + 1);
  for (auto& argument : with_recipe(verb, mine)) all.push_back(std::move(argument));
  return all;
}

std::string recipe_named_in(const CLI::App& program, const std::vector<std::string>& arguments) {
  const auto word = word_in(arguments);
  if (word == arguments.end()) return {};
  return apart(verb_named(program, *word), {word + 1, arguments.end()}).recipe;
}

std::string recipe_of(const CLI::App& verb) { return request::recipe_of(parameters_of(verb)); }

void add_recipe_option(CLI::App& verb) {
  add_parsed(
      verb, "--recipe", [](const std::string&) {},
      "recipe: a TOML file of options without their dashes, or a file that coppermoon made")
      .reads_file()
      .of(request::Affects::run);
}

}  // namespace coppermoon::verbs
