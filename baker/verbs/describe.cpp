// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "algebra/number.h"
#include "uses/light/header.h"
#include "verbs/command_line.h"
#include "verbs/flags/guide.h"

namespace coppermoon::verbs {
namespace of_describe {
namespace {

using Json = nlohmann::ordered_json;
using request::Affects, request::Kind, request::Parameter;

struct Options {
  std::vector<std::string> commands;
  bool json = false;
};

const char* name(Kind kind) {
  constexpr const char* names[] = {"number",       "whole",         "natural", "word",
                                   "on-off",       "presence",      "text",    "file-read",
                                   "file-written", "folder-written"};
  return names[static_cast<std::size_t>(kind)];
}

const char* name(Affects what) {
  constexpr const char* names[] = {"photons", "light",   "ground", "sight",
                                   "frame",   "picture", "share",  "run"};
  return names[static_cast<std::size_t>(what)];
}

/// Converts a number to JSON. Whole numbers have no decimal point.
Json number(double value) {
  if (std::abs(value) < 1e15 && value == std::floor(value)) return static_cast<std::int64_t>(value);
  return value;
}

Json usual_of(const Parameter& parameter) {
  const auto value = is_number(parameter.kind) ? algebra::number_in(parameter.usual) : std::nullopt;
  return value ? number(*value) : Json(parameter.usual);
}

Json as_json(const request::Condition& condition) {
  Json json{{"name", condition.name}};
  if (!condition.values.empty()) json["values"] = condition.values;
  return json;
}

/// How a parameter's effect depends on others, such as {"only_with": [{"name": "solver", "values": ["literal"]}]}.
Json as_json(const request::Relation& relation) {
  auto conditions = Json::array();
  for (const auto& condition : relation.conditions) conditions.push_back(as_json(condition));
  Json json{{relation.needed ? "only_with" : "not_beside", conditions}};
  if (!relation.of.empty()) json["of"] = relation.of;
  return json;
}

Json as_json(const Parameter& parameter) {
  Json json{{"name", parameter.name}, {"kind", name(parameter.kind)}};
  if (const auto unit = unit_of(parameter); !unit.empty()) json["unit"] = unit;
  if (const auto& range = parameter.range)
    json["range"] = {number(range->low), number(range->high)};
  if (!parameter.words.empty()) json["words"] = parameter.words;
  if (!parameter.usual.empty()) json["default"] = usual_of(parameter);
  json["many"] = parameter.many;
  json["required"] = parameter.is_required;
  if (!parameter.heading.empty()) json["heading"] = parameter.heading;
  json["recipe"] = in_recipes(parameter);
  if (!parameter.table.empty()) json["table"] = parameter.table;
  json["affects"] = name(parameter.affects);
  for (const auto& [ending, holds] : parameter.endings) json["endings"][ending] = holds;
  for (const auto& relation : parameter.relations) json["effect"].push_back(as_json(relation));
  json["meaning"] = parameter.meaning;
  if (parameter.parts)
    for (const auto& part : *parameter.parts) json["parts"].push_back(as_json(part));
  return json;
}

Json as_json(const Verb& verb) {
  auto parameters = Json::array();
  for (const auto& parameter : verb.parameters) parameters.push_back(as_json(parameter));
  Json json{{"name", verb.name}, {"meaning", verb.help}, {"parameters", parameters}};
  for (const auto& document : verb.documents)
    json["documents"].push_back(result::as_json(document()));
  return json;
}

/// Values that a parameter allows, such as "0 to 1000 DU" or "on, off", or else their kind, such as "number".
std::string allowed(const Parameter& parameter) {
  const auto unit = unit_of(parameter);
  const auto values =
      parameter.range ? fmt::format("{:g} to {:g}", parameter.range->low, parameter.range->high)
      : parameter.words.empty() ? name(parameter.kind)
                                : fmt::format("{}", fmt::join(parameter.words, ", "));
  return unit.empty() ? values : values + " " + unit;
}

void print(const Parameter& parameter, int indent) {
  fmt::print("{:{}}{:<{}} {:<8} {:<14} {}\n", "", indent, parameter.name, 26 - indent,
             name(parameter.affects), parameter.usual.empty() ? "-" : parameter.usual,
             allowed(parameter));
  if (parameter.parts)
    for (const auto& part : *parameter.parts) print(part, indent + 2);
}

void print(const Verb& verb) {
  fmt::print("{}\n  {:<24} {:<8} {:<14} {}\n", verb.name, "parameter", "affects", "default",
             "allowed");
  for (const auto& parameter : verb.parameters) print(parameter, 2);
}

/// The commands that the user named, or all commands, in the order in which help lists them.
std::vector<const Verb*> chosen(const Program& program, const Options& options) {
  std::vector<const Verb*> verbs;
  for (const auto& group : guides())
    for (const auto& guide : group.guides)
      if (options.commands.empty() || std::ranges::count(options.commands, guide.verb))
        verbs.push_back(&*std::ranges::find(program.verbs, guide.verb, &Verb::name));
  return verbs;
}

void run(const Program& program, const Options& options) {
  const auto verbs = chosen(program, options);
  if (!options.json) {
    for (const auto* verb : verbs) print(*verb);
    return;
  }
  auto commands = Json::array();
  for (const auto* verb : verbs) commands.push_back(as_json(*verb));
  fmt::print("{}\n", Json{{"version", uses::version()}, {"commands", commands}}.dump(2));
}

}  // namespace
}  // namespace of_describe

void add_describe(Program& program) {
  using namespace of_describe;
  auto& verb = add_verb(program, "describe",
                        "lists the parameters of commands: kind, unit, range, words, default");
  const auto options = std::make_shared<Options>();
  std::vector<std::string> names;
  for (const auto& other : program.verbs) names.push_back(other.name);
  add_flag(verb, "commands,--commands", options->commands, "commands to describe; default: all")
      .one_of(names)
      .of(request::Affects::run);
  add_run_switch(verb, "--json", options->json, "prints one JSON document");
  verb.run = [&program, options] { run(program, *options); };
}

}  // namespace coppermoon::verbs
