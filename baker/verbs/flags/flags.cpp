// SPDX-License-Identifier: MIT
#include "verbs/flags/flags.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "request/recipe.h"

namespace coppermoon::verbs {

using request::Affects, request::Parameter;

Program::Program() {
  of_all.begin("", "", Affects::run);
  of_all.add(request::presence("-h,--help", help, "explains the command, with its common options"));
  of_all.add(
      request::presence("--help-all", help_all, "explains the command, with all its options"));
  of_all
      .add(request::parameter("--threads", threads, "number of threads; 0: one for each processor"))
      .within(0, 512)
      .usual.clear();
}

Verb* find_verb(Program& program, std::string_view name) {
  const auto found = std::ranges::find(program.verbs, name, &Verb::name);
  return found == program.verbs.end() ? nullptr : &*found;
}

std::vector<const Parameter*> flags_of(const Verb& verb) {
  std::vector<const Parameter*> all;
  for (const auto& parameter : verb.parameters) all.push_back(&parameter);
  if (verb.program != nullptr)
    for (const auto& parameter : verb.program->of_all) all.push_back(&parameter);
  return all;
}

Parameter* flag_of(Verb& verb, std::string_view flag) {
  for (auto* parameters : {&verb.parameters, verb.program ? &verb.program->of_all : nullptr})
    if (parameters != nullptr)
      for (auto& parameter : *parameters)
        if (parameter.name == flag || parameter.spelling.starts_with(std::string(flag) + ",-"))
          return &parameter;
  return nullptr;
}

Parameter& add_flag(Verb& verb, Parameter parameter) {
  verb.parameters.begin("", "", Affects::ground);
  return verb.parameters.add(std::move(parameter));
}

void add_flags(Verb& verb, request::Parameters parameters) {
  for (auto& parameter : parameters) verb.parameters.keep(std::move(parameter));
}

Parameter& add_parsed(Verb& verb, const std::string& names,
                      std::function<void(const std::string&)> take, const std::string& help,
                      const std::string& text) {
  Parameter parameter{.name = request::name_in(names), .spelling = names, .meaning = help};
  parameter.read = [text] { return text.empty() ? request::Texts{} : request::Texts{text}; };
  parameter.write = [take = std::move(take)](const request::Texts& texts) { take(texts.back()); };
  parameter.restore = [] {};
  return add_flag(verb, std::move(parameter));
}

Parameter& add_switch(Verb& verb, const std::string& names, bool& value, const std::string& help) {
  return add_flag(verb, request::presence(names, value, help));
}

Parameter& add_run_switch(Verb& verb, const std::string& names, bool& value,
                          const std::string& help) {
  return add_switch(verb, names, value, help).of(Affects::run);
}

Parameter& add_json_switch(Verb& verb, bool& value, Documents documents, const std::string& help) {
  verb.documents = std::move(documents);
  return add_run_switch(verb, "--json", value, help);
}

Verb& add_verb(Program& program, const std::string& name, const std::string& help) {
  return program.verbs.emplace_back(Verb{.name = name, .help = help, .program = &program});
}

void on_run(Verb& verb, std::function<void()> run) {
  add_parsed(
      verb, "--recipe", [](const std::string&) {},
      "recipe: a TOML file of options without their dashes, or a file that coppermoon made")
      .reads_file()
      .of(Affects::run);
  verb.run = std::move(run);
}

void say_what_has_no_effect(const Verb& verb) {
  for (const auto& line : without_effect(
           verb.parameters, [](const auto& parameter) { return "--" + parameter.name; },
           [&](const auto& parameter) {
             const bool recorded =
                 std::ranges::find(verb.recorded, parameter.name) != verb.recorded.end();
             return is_typed(verb, parameter.name) ||
                    (!recorded && parameter.text() != parameter.usual);
           }))
    fmt::print(stderr, "coppermoon: {}\n", line);
}

bool is_given(const Verb& verb, std::string_view name) {
  const auto* parameter = verb.parameters.find(name);
  return parameter != nullptr && parameter->given;
}

bool is_typed(const Verb& verb, std::string_view name) {
  return std::ranges::find(verb.typed, name) != verb.typed.end();
}

std::string recipe_of(const Verb& verb) { return text_of(request::recipe_of(verb.parameters)); }

}  // namespace coppermoon::verbs
