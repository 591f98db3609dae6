// SPDX-License-Identifier: MIT
#include "verbs/command_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "algebra/error.h"
#include "eclipse/moment.h"
#include "uses/light/header.h"
#include "verbs/flags/help.h"
#include "verbs/flags/known_words.h"
#include "verbs/flags/moments.h"
#include "verbs/flags/named_files.h"
#include "verbs/recipes/recipe_file.h"
#include "verbs/reports/one_line.h"
#include "verbs/reports/progress_bar.h"

namespace coppermoon::verbs {
namespace {

using request::Kind, request::Parameter, request::Texts;
using Words = std::vector<std::string>;

/// A parameter, and the values given for it on the command line, as text.
struct Typed {
  Parameter* parameter;
  Texts texts;
};

/// A command line, and how far it has been read.
struct Line {
  Verb& verb;
  const Words& words;
  std::size_t next = 0;
  std::vector<Typed> typed{};
  Words unexpected{};

  bool at_end() const { return next == words.size(); }

  Texts& texts_of(Parameter& parameter) {
    const auto known = std::ranges::find(typed, &parameter, &Typed::parameter);
    return (known == typed.end() ? typed.emplace_back(Typed{&parameter, {}}) : *known).texts;
  }
  /// Takes the next value. A day followed by a contact or time, as in "2018-07-27 U2+10min", is a single value.
  std::string value() {
    auto value = words[next++];
    if (!at_end() && eclipse::is_day(value) && eclipse::is_contact_or_time(words[next]))
      value += " " + words[next++];
    return value;
  }
};

/// Whether a word is a flag such as "-o" or "--output". A negative number is not.
bool is_flag(const std::string& word) {
  return word.size() > 1 && word[0] == '-' && word.find_first_of("0123456789.", 1) != 1;
}

WrongUsage unknown_short(const Verb& verb, const std::string& name) {
  std::vector<std::string> flags;
  for (const auto& parameter : verb.parameters)
    if (is_written(parameter.kind)) flags.push_back("--" + parameter.name);
  if (name != "-o") return WrongUsage(fmt::format("{}: unexpected argument", name));
  return WrongUsage(
      fmt::format("-o: unknown option of {}; {}", verb.name,
                  flags.empty() ? "it prints its results"
                                : fmt::format("files are named by {}", fmt::join(flags, ", "))));
}

/// Advice to append to the error message about an unknown flag.
std::string way_out_for(const std::string& flag, const Verb& verb) {
  if (flag == "verbose" || flag == "progress")
    return "; progress is shown wherever the output is a terminal";
  if (flag == "quiet") return "; 2>/dev/null hides what is said beside the results";
  const auto suggestion = flag_suggested_for(flag, names_of(verb));
  return suggestion.empty() ? fmt::format("; `coppermoon {} --help-all` lists them", verb.name)
                            : suggestion;
}

WrongUsage unknown(const Verb& verb, const std::string& flag) {
  if (!flag.starts_with("--")) return unknown_short(verb, flag);
  const auto way_out = way_out_for(flag.substr(2), verb);
  return WrongUsage(fmt::format("{}: unknown option of {}{}", flag, verb.name, way_out));
}

/// Reads a flag and its value, as in "--output FILE", "--output=FILE", "-o FILE", "-oFILE" or "--json".
void read_flag(Line& line) {
  const auto word = line.words[line.next++];
  const bool is_long = word.starts_with("--");
  const auto end = is_long ? std::min(word.find('='), word.size()) : 2;
  const auto flag = word.substr(0, end);
  auto* parameter = flag_of(line.verb, is_long ? flag.substr(2) : flag);
  if (parameter == nullptr) throw unknown(line.verb, flag);
  auto& texts = line.texts_of(*parameter);
  const bool has_sign = end < word.size() && word[end] == '=';
  if (has_sign && end + 1 == word.size())  // otherwise the next word would become the value
    throw WrongUsage(fmt::format("{}: a value is missing behind the =", flag));
  if (end < word.size()) return texts.push_back(word.substr(has_sign ? end + 1 : end));
  if (parameter->kind == Kind::presence) return texts.push_back("true");
  if (line.at_end()) throw WrongUsage(fmt::format("--{}: a value is missing", parameter->name));
  texts.push_back(line.value());
  while (parameter->many && parameter->is_positional() && !line.at_end() &&
         !is_flag(line.words[line.next]))
    texts.push_back(line.value());
}

/// Reads a value without a flag before it. It is for a parameter whose flag may be left out, such as --instant.
void read_positional(Line& line) {
  auto value = line.value();
  for (auto& parameter : line.verb.parameters)
    if (parameter.is_positional())
      if (auto& texts = line.texts_of(parameter); texts.empty() || parameter.many)
        return texts.push_back(std::move(value));
  line.unexpected.push_back(std::move(value));
}

Line line_of(Verb& verb, const Words& words) {
  Line line{verb, words};
  for (bool flags = true; !line.at_end();)
    if (flags && words[line.next] == "--")
      flags = false, ++line.next;
    else if (flags && is_flag(words[line.next]))
      read_flag(line);
    else
      read_positional(line);
  std::erase_if(line.typed, [](const Typed& one) { return one.texts.empty(); });
  return line;
}

/// If the command line names a file made by coppermoon where a moment is expected, uses that file as the recipe.
void find_recipe(Line& line) {
  auto* recipe = line.verb.parameters.find("recipe");
  if (recipe == nullptr) return;
  auto& named = line.texts_of(*recipe);
  if (named.size() > 1) throw WrongUsage("--recipe: given twice, allowed once");
  for (auto& [parameter, texts] : line.typed)
    if (parameter->is_positional() &&
        (parameter->name == "instant" || parameter->name == "eclipse"))
      if (named.empty() && !texts.empty() && holds_recipe(texts.front())) named.swap(texts);
  std::erase_if(line.typed, [](const Typed& one) { return one.texts.empty(); });
}

void take(const Typed& typed) {
  auto texts = typed.texts;
  if (!typed.parameter->many) texts = {texts.back()};
  try {
    typed.parameter->take(texts);
  } catch (const request::UnknownWord& error) {
    throw WrongUsage(fmt::format("--{}", error.what()));
  }
}

/// Whether a command line asks for help. If it does, sets the parameters of the help flags, but of no other flags.
bool asks_for_help(const Line& line) {
  bool help = false;
  for (const auto& one : line.typed)
    if (one.parameter->name.starts_with("help")) take(one), help = true;
  return help;
}

/// Error message for a required parameter that is missing. A missing moment is called INSTANT, as in the help.
std::string missing(const std::string& name) {
  if (name == "instant") return "INSTANT: missing; a moment is needed, as 2026-03-03";
  if (name == "eclipse") return "ECLIPSE: missing; a day is needed, as 2026-03-03";
  return fmt::format("--{}: missing", name);
}

void require_complete(const Verb& verb) {
  for (const auto& parameter : verb.parameters)
    if (parameter.is_required && !parameter.given) throw WrongUsage(missing(parameter.name));
  const auto excludes = [](const Parameter& one, const Parameter& other) {
    return std::ranges::count(one.excluded, other.name) > 0;
  };
  for (auto one = verb.parameters.begin(); one != verb.parameters.end(); ++one)
    for (auto other = one + 1; other != verb.parameters.end(); ++other)
      if (one->given && other->given && (excludes(*one, *other) || excludes(*other, *one)))
        throw WrongUsage(
            fmt::format("--{} and --{}: allowed one of the two", one->name, other->name));
}

Words names_of(const Program& program) {
  Words names;
  for (const auto& verb : program.verbs) names.push_back(verb.name);
  return names;
}

Verb& verb_named(Program& program, const std::string& name) {
  if (auto* verb = find_verb(program, name)) return *verb;
  const auto suggestion = verb_suggested_for(name, names_of(program));
  throw WrongUsage(
      fmt::format("{}: unknown command{}", name,
                  suggestion.empty() ? "; `coppermoon --help` lists the commands" : suggestion));
}

}  // namespace

void add_verbs(Program& program) {
  for (const auto add :
       {add_almanac, add_night, add_explore, add_sky,    add_plan,     add_shadow,   add_brightness,
        add_bake,    add_ring,  add_dome,    add_shader, add_scene,    add_still,    add_animate,
        add_develop, add_merge, add_compare, add_fit,    add_tradeoff, add_describe, add_cache})
    add(program);
}

void take(Verb& verb, const Words& words) {
  auto line = line_of(verb, words);
  if (asks_for_help(line)) return;
  find_recipe(line);
  verb.typed.clear();
  for (const auto& one : line.typed) verb.typed.push_back(one.parameter->name);
  for (const auto& one : line.typed)
    if (one.parameter->name == "recipe") take_recipe(verb, one.texts.front());
  for (const auto& one : line.typed) take(one);
  require_complete(verb);
  if (!line.unexpected.empty())
    throw WrongUsage(fmt::format("{}: unexpected argument{}", fmt::join(line.unexpected, " "),
                                 line.unexpected.size() > 1 ? "s" : ""));
}

Asked asked_by(Program& program, Words words) {
  for (const auto& word : words)
    if (!is_utf8(word)) throw WrongUsage(fmt::format("argument '{}', allowed is UTF-8", word));
  if (words.empty())
    throw WrongUsage(fmt::format("a command is required: {}; `coppermoon --help` explains them",
                                 fmt::join(names_of(program), ", ")));
  const auto first = words.front();
  if (first == "version" || first == "--version")
    return {nullptr, fmt::format("coppermoon {}\n", uses::version())};
  const bool all = first == "--help-all",
             help = all || first == "help" || first == "--help" || first == "-h";
  if (help) words.erase(words.begin());
  if (help && words.empty()) return {nullptr, program_help(program)};
  auto& verb = verb_named(program, words.front());
  words.erase(words.begin());
  if (help) words.insert(words.begin(), all ? "--help-all" : "--help");
  take(verb, words);
  if (program.help_all) return {&verb, full_help(verb)};
  return {&verb, program.help ? short_help(verb) : ""};
}

void run(Verb& verb) {
  std::optional<tbb::global_control> threads;
  if (verb.program->threads > 0)
    threads.emplace(tbb::global_control::max_allowed_parallelism, verb.program->threads);
  require_files_apart(verb);
  say_which_city(verb);
  say_what_is_utc(verb);
  say_what_has_no_effect(verb);
  const AtWork at_work(verb.name);
  verb.run();
}

}  // namespace coppermoon::verbs
