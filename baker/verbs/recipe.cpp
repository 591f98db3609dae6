// SPDX-License-Identifier: MIT
#include "verbs/recipe.h"

#include <toml++/toml.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <sstream>

#include "algebra/error.h"
#include "texture/read_image.h"

namespace coppermoon::verbs {
namespace {

/// Number of letters to insert, drop or change to make one word of the other (Levenshtein).
std::size_t letters_apart(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0U);
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t change = diagonal + (a[i] != b[j]);
      diagonal = row[j + 1];
      row[j + 1] = std::min({change, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

std::string nearest(std::string_view word, const std::vector<std::string>& known) {
  return *std::min_element(known.begin(), known.end(), [&](const auto& a, const auto& b) {
    return letters_apart(word, a) < letters_apart(word, b);
  });
}

/// An unknown word on the command line: exit status 2.
struct UnknownWord : CLI::ParseError {
  explicit UnknownWord(const std::string& text)
      : CLI::ParseError("UnknownWord", text, CLI::ExitCodes::ExtrasError) {}
};

std::vector<std::string> long_flags(const CLI::App& verb) {
  std::vector<std::string> flags;
  for (const auto* option : verb.get_options())
    for (const auto& name : option->get_lnames()) flags.push_back(name);
  return flags;
}

void require_flag(const CLI::App& verb, const std::string& flag, const std::string& where,
                  const std::string& dashes) {
  const auto flags = long_flags(verb);
  if (std::find(flags.begin(), flags.end(), flag) != flags.end()) return;
  throw UnknownWord(fmt::format("{}{}{}: {} has no such {}; the nearest is {}{}", where, dashes,
                                flag, verb.get_name(), dashes.empty() ? "key" : "flag", dashes,
                                nearest(flag, flags)));
}

std::vector<std::string> words_of(const CLI::App& program) {
  std::vector<std::string> words;
  for (const auto* verb : program.get_subcommands({})) words.push_back(verb->get_name());
  return words;
}

const CLI::App& verb_named(const CLI::App& program, const std::string& name) {
  for (const auto* verb : program.get_subcommands({}))
    if (verb->get_name() == name) return *verb;
  throw UnknownWord(
      fmt::format("{}: no such word; the nearest is {}", name, nearest(name, words_of(program))));
}

std::string as_text(const toml::node& value, const std::string& where) {
  std::ostringstream text;
  if (const auto* word = value.as_string()) return word->get();
  if (const auto* integer = value.as_integer())
    text << integer->get();
  else if (const auto* number = value.as_floating_point())
    text << fmt::format("{}", number->get());
  else if (const auto* truth = value.as_boolean())
    text << (truth->get() ? "true" : "false");
  else if (const auto* when = value.as_date_time())
    text << when->get();
  else if (const auto* list = value.as_array()) {
    for (const auto& item : *list) text << (text.tellp() > 0 ? "," : "") << as_text(item, where);
  } else {
    throw algebra::Error(
        fmt::format("{}: allowed are texts, numbers, dates, true, false and lists", where));
  }
  return text.str();
}

std::string recipe_text(const std::string& path) {
  if (std::filesystem::path(path).extension() != ".exr") {
    std::ifstream file(path);
    if (!file || std::filesystem::is_directory(path))
      throw algebra::Error(fmt::format("{}: cannot be read", path));
    return {std::istreambuf_iterator<char>(file), {}};
  }
  const auto text = texture::read_attribute(path, "coppermoon:recipe");
  if (!text) throw algebra::Error(fmt::format("{}: has no recipe in its header", path));
  return *text;
}

toml::table parsed(const std::string& path) {
  try {
    return toml::parse(recipe_text(path), path);
  } catch (const toml::parse_error& error) {
    throw algebra::Error(
        fmt::format("{}:{}: {}", path, error.source().begin.line, error.description()));
  }
}

/// `on` and `off` may be written true and false.
std::string spelt(const CLI::App& verb, const std::string& key, const toml::node& value,
                  const std::string& text) {
  const auto* option = verb.get_option_no_throw("--" + key);
  const bool flag = option != nullptr && option->get_items_expected_max() == 0;
  if (!value.is_boolean() || flag) return text;
  return text == "true" ? "on" : "off";
}

bool names(const std::vector<std::string>& arguments, const std::string& flag) {
  return std::any_of(arguments.begin(), arguments.end(), [&](const auto& argument) {
    return argument.substr(0, argument.find('=')) == "--" + flag;
  });
}

/// Without those the user names too: lists would be joined otherwise.
std::vector<std::string> flags_of_recipe(const CLI::App& verb, const std::string& path,
                                         const std::vector<std::string>& mine) {
  std::vector<std::string> flags;
  // A recipe that another verb wrote into a file may know more than this one asks for.
  const bool lenient = std::filesystem::path(path).extension() == ".exr";
  const auto known = long_flags(verb);
  for (const auto& [key, value] : parsed(path)) {
    const std::string name(key.str());
    if (lenient && std::find(known.begin(), known.end(), name) == known.end()) continue;
    const std::string where = fmt::format("{}:{}: ", path, value.source().begin.line);
    require_flag(verb, name, where, "");
    const std::string text = spelt(verb, name, value, as_text(value, where + name));
    if (!names(mine, name)) flags.push_back(fmt::format("--{}={}", name, text));
  }
  return flags;
}

std::string quoted(const std::string& text) {
  std::ostringstream literal;
  literal << toml::value<std::string>(text);
  return literal.str();
}

/// An option's value as TOML, numbers spelt alike however the user spelt them; empty when it has
/// none.
std::string toml_value(const CLI::Option& option) {
  const std::string text = option.count() > 0 ? option.results().back() : option.get_default_str();
  if (text.empty()) return text;
  const std::string type = option.get_type_name();
  if (type.starts_with("FLOAT")) return fmt::format("{}", option.as<double>());
  if (type.starts_with("INT")) return fmt::format("{}", option.as<std::int64_t>());
  if (!type.starts_with("UINT")) return quoted(text);
  const auto value = option.as<std::uint64_t>();  // TOML's own integers end at 2^63
  return value >> 63 ? quoted(text) : fmt::format("{}", value);
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

void require_flags(const CLI::App& verb, const std::vector<std::string>& arguments) {
  for (const auto& argument : arguments)
    if (argument.starts_with("--") && argument.size() > 2)
      require_flag(verb, argument.substr(2, argument.find('=') - 2), "", "--");
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

/// The recipe's flags, and behind them the user's own.
std::vector<std::string> with_recipe(const CLI::App& verb, std::vector<std::string> mine) {
  std::string path = taken_recipe(mine);
  if (!taken_recipe(mine).empty()) throw UnknownWord("--recipe: given twice, allowed once");
  const std::string flag = flag_of_positional(verb);
  if (const auto own = positional(verb, mine); own != mine.end() && !flag.empty()) {
    if (path.empty() && flag == "--instant" && own->ends_with(".exr")) {
      path = *own;
      mine.erase(own);
    } else if (!path.empty()) {
      *own = flag + "=" + *own;
    }
  }
  if (path.empty()) return mine;
  auto arguments = flags_of_recipe(verb, path, mine);
  arguments.insert(arguments.end(), mine.begin(), mine.end());
  return arguments;
}

}  // namespace

std::vector<std::string> with_recipes(const CLI::App& program, std::vector<std::string> arguments) {
  const auto word = std::find_if(arguments.begin(), arguments.end(),
                                 [](const auto& a) { return !a.starts_with("-"); });
  if (word == arguments.end() && arguments.empty())
    throw UnknownWord(fmt::format("a word is required: {}; --help explains them",
                                  fmt::join(words_of(program), ", ")));
  if (word == arguments.end()) return arguments;
  const CLI::App& verb = verb_named(program, *word);
  const std::vector<std::string> mine(word + 1, arguments.end());
  require_flags(verb, mine);
  arguments.erase(word + 1, arguments.end());
  for (auto& argument : with_recipe(verb, mine)) arguments.push_back(std::move(argument));
  return arguments;
}

std::string recipe_of(const CLI::App& verb) {
  std::string text;
  constexpr std::array<std::string_view, 7> no_part{"help",    "recipe", "json", "output",
                                                    "threads", "frame",  "plot"};
  for (const auto* option : verb.get_options()) {
    if (option->get_lnames().empty()) continue;
    const std::string& name = option->get_lnames().front();
    if (std::find(no_part.begin(), no_part.end(), name) != no_part.end()) continue;
    if (option->get_items_expected_max() == 0) {
      if (option->count() > 0) text += name + " = true\n";
      continue;
    }
    if (const auto value = toml_value(*option); !value.empty()) text += name + " = " + value + "\n";
  }
  return text;
}

void add_recipe_option(CLI::App& verb) {
  verb.add_option_function<std::string>(
      "--recipe", [](const std::string&) {},
      "TOML file of flags without their dashes, or an .exr made by coppermoon");
}

}  // namespace coppermoon::verbs
