// SPDX-License-Identifier: MIT
#include "verbs/recipes/recipe.h"

#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <cstdint>
#include <sstream>

#include "algebra/number.h"
#include "atmosphere/presets.h"
#include "files/name_to_share.h"
#include "verbs/flags/air_options.h"
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

bool is_control(char c) { return (c >= 0 && c < ' ') || c == '\x7F'; }

/// As a text in TOML that stays on its line.
std::string quoted(const std::string& text) {
  if (std::ranges::none_of(text, is_control)) {
    std::ostringstream literal;
    literal << toml::value<std::string>(text);
    return literal.str();
  }
  std::string literal = "\"";
  for (const char c : text)
    if (is_control(c))
      literal += fmt::format("\\u{:04x}", static_cast<int>(c));
    else
      literal += c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
  return literal + "\"";
}

/// An option's value as TOML, numbers spelt alike however the user spelt them; empty when it has
/// none.
std::string toml_value(const CLI::Option& option) {
  const std::string told = option.count() > 0 ? option.results().back() : option.get_default_str();
  const std::string text =
      option.check_lname("atmosphere") ? std::string(atmosphere::lasting_name(told)) : told;
  if (text.empty()) return text;
  if (option.get_type_name() == read_file) return quoted(files::name_to_share(text));
  const std::string type = option.get_type_name();
  if (type.starts_with("FLOAT"))  // TOML has no -0 that is whole
    return fmt::format("{}", option.as<double>() + 0.);
  if (type.starts_with("INT")) return fmt::format("{}", option.as<std::int64_t>());
  if (const auto number = algebra::number_in(text); number && option.check_lname("field"))
    return fmt::format("{}", *number + 0.);  // a number, or "moon"
  if (!type.starts_with("UINT")) return quoted(text);
  const auto value = option.as<std::uint64_t>();  // TOML's own integers end at 2^63
  return value >> 63 ? quoted(text) : fmt::format("{}", value);
}

std::string toml_line(const CLI::Option& option) {
  const auto value = toml_value(option);
  return value.empty() ? "" : option.get_lnames().front() + " = " + value + "\n";
}

/// Text as a region's flag has it, as a table.
std::string region_table(const std::string& text) {
  RegionReader reader;
  reader.read(text);
  std::string table = "\n[[atmosphere.region]]\n";
  for (const auto* option : reader.app().get_options())
    if (option->count() > 0) table += toml_line(*option);
  return table;
}

/// Nothing without regions: --atmosphere is a flag like any other then.
std::string air_tables(const CLI::App& verb) {
  const auto* regions = verb.get_option_no_throw("--region");
  if (regions == nullptr || regions->count() == 0) return {};
  std::string tables =
      "\n[atmosphere]\nmodel = " + toml_value(*verb.get_option("--atmosphere")) + "\n";
  for (const auto& text : regions->results()) tables += region_table(text);
  return tables;
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

/// Where there is no -o, which flags name the files.
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

/// What is said of a flag that there is not.
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

/// The first argument that is neither a flag nor a flag's value.
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

/// The flag that an argument without one stands for.
std::string flag_of_positional(const CLI::App& verb) {
  for (const auto* option : verb.get_options())
    if (option->get_positional() && !option->get_lnames().empty())
      return "--" + option->get_lnames().front();
  return {};
}

/// A verb's arguments, and the recipe among them.
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

/// The recipe's flags, and behind them the user's own.
std::vector<std::string> with_recipe(const CLI::App& verb, std::vector<std::string> all) {
  const auto [path, mine] = apart(verb, std::move(all));
  if (path.empty()) return mine;
  auto arguments = flags_of_recipe(verb, path, mine);
  arguments.insert(arguments.end(), mine.begin(), mine.end());
  return arguments;
}

/// Flags and their values; all regions of the air as one.
using Lines = std::vector<std::pair<std::string, std::string>>;

Lines lines_of(const std::string& recipe) {
  std::istringstream text(recipe);
  Lines lines;
  bool in_tables = false;
  for (std::string line; std::getline(text, line);) {
    if (line.empty()) continue;
    const auto sign = line.find(" = ");
    if (line == "[atmosphere]")
      in_tables = true;
    else if (in_tables && line.starts_with("model = "))
      lines.emplace_back("atmosphere", line.substr(sign + 3));
    else if (in_tables && lines.back().first == "regions")
      lines.back().second += "; " + line;
    else if (in_tables)
      lines.emplace_back("regions", line);
    else
      lines.emplace_back(line.substr(0, sign), sign == line.npos ? "" : line.substr(sign + 3));
  }
  return lines;
}

Lines::const_iterator line_in(const Lines& lines, const std::string& flag) {
  return std::ranges::find(lines, flag, &Lines::value_type::first);
}

/// The first argument that is no flag.
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

std::string recipe_of(const CLI::App& verb) {
  std::string text;
  const std::string tables = air_tables(verb);
  auto no_part = no_part_of_recipes();
  no_part.push_back("region");
  if (!tables.empty()) no_part.push_back("atmosphere");
  for (const auto* option : verb.get_options()) {
    if (option->get_lnames().empty() || holds(no_part, option->get_lnames().front())) continue;
    if (option->get_items_expected_max() > 0)
      text += toml_line(*option);
    else if (option->count() > 0)
      text += option->get_lnames().front() + " = true\n";
  }
  return text + tables;
}

std::string without(const std::string& recipe,
                    const std::function<bool(const std::string& flag)>& dropped) {
  std::istringstream lines(recipe);
  std::string left;
  bool in_tables = false;
  for (std::string line; std::getline(lines, line);) {
    in_tables = in_tables || line.starts_with("[");
    if (in_tables || !dropped(line.substr(0, line.find(' ')))) left += line + "\n";
  }
  return left;
}

std::vector<RecipeDifference> recipe_differences(const std::string& first,
                                                 const std::string& second) {
  const auto a = lines_of(first), b = lines_of(second);
  std::vector<RecipeDifference> all;
  for (const auto& [flag, value] : a) {
    const auto other = line_in(b, flag);
    if (other == b.end() || other->second != value)
      all.push_back({flag, value, other == b.end() ? "none" : other->second});
  }
  for (const auto& [flag, value] : b)
    if (line_in(a, flag) == a.end()) all.push_back({flag, "none", value});
  return all;
}

std::string with_width(const std::string& recipe, std::size_t width) {
  return fmt::format("texture-width = {}\n", width) +
         without(recipe, [](const std::string& flag) { return flag == "texture-width"; });
}

void add_recipe_option(CLI::App& verb) {
  Flag(*verb.add_option_function<std::string>(
           "--recipe", [](const std::string&) {},
           "recipe: a TOML file of options without their dashes, or a file that coppermoon made"))
      .reads_file();
}

}  // namespace coppermoon::verbs
