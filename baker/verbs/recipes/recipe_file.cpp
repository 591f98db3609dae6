// SPDX-License-Identifier: MIT
#include "verbs/recipes/recipe_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <vector>

#include "algebra/error.h"
#include "algebra/table.h"
#include "colour/camera_spectra.h"
#include "files/name_to_share.h"
#include "files/whole_file.h"
#include "request/likeness.h"
#include "request/recipe.h"
#include "texture/read_image.h"
#include "texture/write_stellarium.h"
#include "uses/picture/picture_parameters.h"
#include "verbs/flags/known_words.h"
#include "verbs/reports/one_line.h"

namespace coppermoon::verbs {
namespace {

using request::Kind, request::Parameter, request::Recipe, request::Setting, request::Texts;

Recipe recipe_of_file(const std::string& path) {
  constexpr std::size_t most_bytes = (1 << 20) + 1;  // one byte more than recipe_in allows
  if (!holds_recipe(path)) {
    const auto bytes = files::beginning_of(path, most_bytes);
    return request::recipe_in(std::string(algebra::utf8_text(bytes, path)), path);
  }
  const auto text = texture::read_attribute(path, "coppermoon:recipe");
  if (!text) throw algebra::Error(fmt::format("{}: has no recipe in its header", path));
  return request::recipe_in(*text, path);
}

/// Keys that a command allows in a table of a recipe or, if `table` is empty, above all tables.
std::vector<std::string> names_in(const Verb& verb, const std::string& table) {
  if (table.empty()) return names_of(verb);
  std::vector<std::string> names;
  for (const auto& parameter : verb.parameters)
    if (parameter.table == table) names.push_back(parameter.name);
  return names;
}

/// Whether the command has a parameter with this setting's name and table.
bool has(const Verb& verb, const Setting& setting) {
  return holds(names_in(verb, setting.table), setting.name);
}

/// Whether any command has a parameter for this setting. If so, all commands accept it, because they can share recipes.
bool is_anothers(const Verb& verb, const Setting& setting) {
  return verb.program != nullptr &&
         std::ranges::any_of(verb.program->verbs,
                             [&](const Verb& other) { return has(other, setting); });
}

/// Makes the error for a key that does not exist in its table.
///
/// Given  known  keys that the table may hold; there must be at least one
WrongUsage no_such_key(const Verb& verb, const std::string& where, const std::string& key,
                       const std::string& table, const std::vector<std::string>& known) {
  const bool above = table != verb.name && holds(names_of(verb), key);
  const auto now = since_there_is_no(key);
  return WrongUsage(fmt::format("{}{}: {} has no such key; {}", where, one_line(key), table,
                                above          ? "it belongs above all tables"
                                : !now.empty() ? std::string(now)
                                               : "the nearest is " + request::nearest(key, known)));
}

WrongUsage unknown(const Verb& verb, const Setting& setting) {
  const auto& [name, texts, parts, bare, table, affects, where] = setting;
  auto known = names_in(verb, table);
  if (table.empty()) return no_such_key(verb, where, name, verb.name, known);
  if (known.empty() && holds(names_of(verb), table))
    throw algebra::Error(
        fmt::format("{}{} is no table, allowed a value above all tables", where, table));
  if (known.empty()) return no_such_key(verb, where, table, verb.name, names_of(verb));
  std::ranges::replace(known, table, "model");
  return no_such_key(verb, where, name, "[" + table + "]", known);
}

/// Throws if a setting says which files to write or how to run. Such settings are allowed only on the command line,
/// because a recipe may come from someone whom the user does not trust.
void require_no_output(Verb& verb, const Setting& setting) {
  const auto* parameter = flag_of(verb, setting.name);
  if (parameter != nullptr && parameter->affects == request::Affects::run)
    throw WrongUsage(
        fmt::format("{}{}: {} is said on the command line alone", setting.where, setting.name,
                    is_written(parameter->kind) ? "where files go" : "how a run goes"));
}

/// The parameter that a setting sets; nullptr if the command ignores the setting.
///
/// Given  lenient  whether to ignore settings that the command lacks, because another command may have written them
Parameter* heeded(Verb& verb, const Setting& setting, bool lenient) {
  auto* parameter = has(verb, setting) ? verb.parameters.find(setting.name) : nullptr;
  if (lenient) return parameter != nullptr && in_recipes(*parameter) ? parameter : nullptr;
  require_no_output(verb, setting);
  if (parameter == nullptr && !is_anothers(verb, setting)) throw unknown(verb, setting);
  return parameter;
}

/// Converts a value with named parts to text for its flag, such as "cloud-cover=1,from-latitude=-90,to-latitude=0".
std::string text_of_parts(const Verb& verb, const Parameter& grouped, const Recipe& value) {
  std::vector<std::string> parts, known;
  for (const auto& part : *grouped.parts) known.push_back(part.name);
  for (const auto& [name, texts, of_part, bare, table, affects, where] : value) {
    if (!holds(known, name)) throw no_such_key(verb, where, name, "a " + grouped.name, known);
    const auto text = fmt::format("{}", fmt::join(texts, ","));
    if (text.empty() || text.find(',') != std::string::npos)
      throw algebra::Error(
          fmt::format("{}{} = '{}', allowed is a number or a word", where, name, text));
    parts.push_back(name + "=" + text);
  }
  return fmt::format("{}", fmt::join(parts, ","));
}

/// Converts the values of a setting to the strings that its parameter expects. In a recipe, true and false may stand
/// for `on` and `off`. A list becomes several values or, if the parameter takes only one, a value with commas.
Texts texts_for(const Verb& verb, const Parameter& parameter, const Setting& setting) {
  if (!setting.parts.empty() && !parameter.parts)
    throw algebra::Error(
        fmt::format("{}{}: allowed are texts, numbers, dates, true, false and lists", setting.where,
                    setting.name));
  auto texts = setting.texts;
  if (!parameter.many && texts.size() > 1) texts = {fmt::format("{}", fmt::join(texts, ","))};
  for (auto& text : texts) {
    if (text.empty())
      throw algebra::Error(
          fmt::format("{}{}: is empty; leave it out instead", setting.where, setting.name));
    if (setting.bare && parameter.kind != Kind::presence && (text == "true" || text == "false"))
      text = text == "true" ? "on" : "off";
  }
  for (const auto& value : setting.parts) texts.push_back(text_of_parts(verb, parameter, value));
  return texts;
}

void take(const Verb& verb, Parameter& parameter, const Setting& setting,
          const std::string& made_file) {
  auto texts = texts_for(verb, parameter, setting);
  if (!made_file.empty() && parameter.kind == Kind::file_read)
    for (auto& text : texts) text = files::shared_file(text, made_file);
  try {
    parameter.take(texts);
  } catch (const request::UnknownWord& error) {
    throw WrongUsage(setting.where + error.what());
  } catch (const algebra::Error& error) {
    throw algebra::Error(setting.where + error.what());
  }
}

/// Converts the recipe of a film, which every frame's file holds, to a recipe for the one frame in this file.
Recipe of_frame(Verb& verb, const std::string& path, const Recipe& recipe) {
  const auto is_open = [&](const char* name) {
    return verb.parameters.find(name) != nullptr && !is_typed(verb, name);
  };
  const auto text_in = [&](const char* name) {
    const auto* setting = setting_in(recipe, name);
    return setting == nullptr || setting->texts.empty() ? "" : setting->texts.front();
  };
  const auto instant = is_open("instant") && setting_in(recipe, "instant") == nullptr
                           ? texture::read_attribute(path, "coppermoon:instant")
                           : std::nullopt;
  if (!instant) return recipe;
  const auto mount = text_in("mount"), up = mount == "horizon" ? "zenith" : text_in("up");
  if (mount == "fixed" && is_open("up"))
    throw algebra::Error(fmt::format(
        "{}: shows where a fixed camera pointed, which `coppermoon animate` alone makes again",
        path));
  auto time = text_in("time");
  if (time.find(':') != std::string::npos)
    time = texture::read_attribute(path, "expTime").value_or("follow");
  auto made = with({{.name = "instant", .texts = {*instant}},
                    {.name = "calendar", .texts = {"gregorian"}},
                    {.name = "up", .texts = {up}},
                    {.name = "time", .texts = {time}}},
                   recipe);
  std::erase_if(made, [](const Setting& setting) {
    return setting.name == "from" || setting.name == "to" || setting.texts == Texts{""};
  });
  return made;
}

}  // namespace

bool holds_recipe(const std::filesystem::path& path) {
  const auto ending = path.extension();
  return ending == ".exr" || ending == ".tx" || ending == ".png" ||
         path.filename() == std::filesystem::path(texture::stellarium_picture).filename();
}

void take_recipe(Verb& verb, const std::string& path) {
  const bool made = holds_recipe(path);
  const auto recipe = recipe_of_file(path);
  for (const auto& setting : made ? of_frame(verb, path, recipe) : recipe)
    if (auto* parameter = heeded(verb, setting, made); parameter && !is_typed(verb, setting.name)) {
      take(verb, *parameter, setting, made ? path : "");
      if (made && parameter->affects <= request::Affects::light)
        verb.recorded.push_back(setting.name);
    }
}

void warn_of_another_camera(const std::string& file, const std::optional<std::string>& response) {
  if (!response || !holds_recipe(file) || !texture::read_attribute(file, "coppermoon:recipe"))
    return;
  Verb recorded;
  std::optional<std::string> made_for;
  add_described(recorded, made_for, uses::describe_response);
  take_recipe(recorded, file);
  if (made_for && colour::is_spectral(*made_for) && *made_for != *response)
    fmt::print(stderr,
               "coppermoon: {}: its colours are those of {}, not of {}: make it anew with "
               "--response {}\n",
               one_line(file), one_line(*made_for), one_line(*response), one_line(*response));
}

}  // namespace coppermoon::verbs
