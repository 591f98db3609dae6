// SPDX-License-Identifier: MIT
#include "verbs/recipes/recipe_file.h"

#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <sstream>

#include "algebra/error.h"
#include "colour/camera_spectra.h"
#include "files/name_to_share.h"
#include "files/whole_file.h"
#include "request/likeness.h"
#include "texture/read_image.h"
#include "texture/write_stellarium.h"
#include "uses/light/light_parameters.h"
#include "uses/picture/picture_parameters.h"
#include "verbs/flags/known_words.h"
#include "verbs/flags/verb.h"
#include "verbs/reports/one_line.h"

namespace coppermoon::verbs {
namespace {

std::string as_text(const toml::node& value, const std::string& where) {
  std::ostringstream text;
  if (const auto* word = value.as_string()) {
    if (word->get().find('\0') != std::string::npos)
      throw algebra::Error(fmt::format("{}: holds a zero byte, allowed is text without", where));
    return word->get();
  }
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

constexpr std::size_t most_bytes = 1 << 20;

std::string recipe_text(const std::string& path) {
  if (!holds_recipe(path)) return files::beginning_of(path, most_bytes + 1);
  const auto text = texture::read_attribute(path, "coppermoon:recipe");
  if (!text) throw algebra::Error(fmt::format("{}: has no recipe in its header", path));
  return *text;
}

/// Bytes between TOML's quotes, quotes included: of one line, or three quotes and several lines.
std::size_t quoted_length(std::string_view text) {
  const char quote = text.front();
  const std::string three(3, quote);
  const std::string mark = text.starts_with(three) ? three : three.substr(2);
  std::size_t end = mark.size();
  while (end < text.size() && !text.substr(end).starts_with(mark))
    end += quote == '"' && text[end] == '\\' ? 2 : 1;
  end += mark.size();
  while (mark == three && end < text.size() && text[end] == quote) ++end;
  return std::min(end, text.size());
}

/// Bytes that are read as one: a quoted text, a comment, or one character.
std::size_t token_length(std::string_view text) {
  if (text.front() == '"' || text.front() == '\'') return quoted_length(text);
  return text.front() == '#' ? std::min(text.find('\n'), text.size()) : 1;
}

/// A name `a.b.c` makes a table in a table in a table, and toml++ goes through them by recursion: one
/// of many parts would be the end of the stack.
void require_short_names(const std::string& path, std::string_view text) {
  constexpr std::ptrdiff_t most_parts = 16;
  constexpr std::string_view of_names =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_\"' \t.";
  std::ptrdiff_t dots = 0, line = 1;
  for (std::size_t length = 0; !text.empty(); text.remove_prefix(length)) {
    length = token_length(text);
    const auto token = text.substr(0, length);
    line += std::ranges::count(token, '\n');
    if (of_names.find(token.front()) == std::string_view::npos) dots = 0;
    if (token == "." && ++dots >= most_parts)
      throw algebra::Error(fmt::format("{}:{}: a name of more than {} parts, allowed up to {}",
                                       path, line, most_parts, most_parts));
  }
}

toml::table parsed(const std::string& path) {
  const auto text = recipe_text(path);
  if (text.size() > most_bytes)
    throw algebra::Error(
        fmt::format("{}: a recipe of more than {} bytes, allowed up to that", path, most_bytes));
  require_short_names(path, text);
  try {
    return toml::parse(text, path);
  } catch (const toml::parse_error& error) {
    throw algebra::Error(
        fmt::format("{}:{}: {}", path, error.source().begin.line, error.description()));
  }
}

/// Recipe that is read for a command.
struct Reading {
  const CLI::App& verb;
  const std::string& path;
  /// Whether keys that the command has not are passed over: another command wrote the recipe into its file.
  bool lenient = holds_recipe(path);

  bool heeds(const std::vector<std::string>& keys, const std::string& flag) const {
    const auto* parameter = parameters_of(verb).find(flag);
    return holds(keys, flag) && (parameter ? in_recipes(*parameter) : flag == "model");
  }
  std::string where(const toml::node& value) const {
    return fmt::format("{}:{}: ", path, value.source().begin.line);
  }
};

/// Key of a recipe, and its value.
struct Entry {
  std::string key;
  const toml::node* value;
  std::string table = {};  ///< "[atmosphere]"; empty: above all tables
};

/// Keys that a table of a recipe may hold.
struct Table {
  std::string name;
  std::vector<std::string> keys;
  std::string model = {};  ///< parameter that it is called after; empty: the keys above all tables
};

/// Keys of a recipe's table: the parameters of the request that it is called after. The parameter with the table's
/// own name is called model there.
Table table_of(const CLI::App& verb, const std::string& name) {
  Table table{"[" + name + "]", {"model"}, name};
  for (const auto& parameter : parameters_of(verb))
    if (parameter.table == name && parameter.name != name) table.keys.push_back(parameter.name);
  return table;
}

bool has_table(const CLI::App& verb, const std::string& name) {
  const auto* model = parameters_of(verb).find(name);
  return model != nullptr && model->table == name;
}

/// Whether a key belongs to another command alone: one recipe serves all.
bool is_anothers(const Reading& reading, const Table& table, const std::string& key) {
  const auto* program = reading.verb.get_parent();
  if (program == nullptr || holds(table.keys, key)) return false;
  return std::ranges::any_of(program->get_subcommands({}), [&](const CLI::App* verb) {
    if (table.model.empty()) return holds(long_flags(*verb), key);
    return has_table(*verb, table.model) && holds(table_of(*verb, table.model).keys, key);
  });
}

bool is_table(const Reading& reading, const Entry& entry) {
  return entry.value->is_table() && has_table(reading.verb, entry.key);
}

void require_key(const Reading& reading, const Table& table, const Entry& entry) {
  if (holds(table.keys, entry.key)) return;
  const bool elsewhere = holds(long_flags(reading.verb), entry.key);
  const auto now = since_there_is_no(entry.key);
  throw WrongUsage(fmt::format(
      "{}{}: {} has no such key; {}", reading.where(*entry.value), one_line(entry.key), table.name,
      elsewhere      ? "it belongs above all tables"
      : !now.empty() ? std::string(now)
                     : "the nearest is " + request::nearest(entry.key, table.keys)));
}

/// Refuses keys that say where files go, or how a run goes: a recipe may be a stranger's.
void require_no_output(const Reading& reading, const Entry& entry) {
  static constexpr std::array of_the_run{"help", "help-all", "threads"};
  const auto* parameter = parameters_of(reading.verb).find(entry.key);
  const bool place = parameter != nullptr && is_written(parameter->kind),
             run = parameter != nullptr && parameter->affects == request::Affects::run;
  if (run || std::ranges::find(of_the_run, entry.key) != of_the_run.end())
    throw WrongUsage(fmt::format("{}{}: {} is said on the command line alone",
                                 reading.where(*entry.value), entry.key,
                                 place ? "where files go" : "how a run goes"));
}

/// Entries of a table in their order.
std::vector<Entry> entries_in(const Reading& reading, const toml::table& entries,
                              const Table& table) {
  std::vector<Entry> all;
  for (const auto& [key, value] : entries) {
    const Entry entry{std::string(key.str()), &value};
    if (reading.lenient && !reading.heeds(table.keys, entry.key)) continue;
    require_no_output(reading, entry);
    if (is_anothers(reading, table, entry.key)) continue;
    require_key(reading, table, entry);
    all.push_back(entry);
  }
  return all;
}

void require_once(const Reading& reading, const std::vector<Entry>& all) {
  for (auto entry = all.begin(); entry != all.end(); ++entry)
    if (std::any_of(all.begin(), entry, [&](const Entry& t) { return t.key == entry->key; }))
      throw algebra::Error(fmt::format("{}{}: given twice, above all tables and in {}",
                                       reading.where(*entry->value), entry->key, entry->table));
}

/// Entries of a recipe, those in tables behind the others.
std::vector<Entry> entries_of(const Reading& reading, const toml::table& recipe) {
  std::vector<Entry> all, in_tables;
  for (const auto& entry :
       entries_in(reading, recipe, {reading.verb.get_name(), long_flags(reading.verb)})) {
    if (!is_table(reading, entry)) {
      all.push_back(entry);
      continue;
    }
    const auto table = table_of(reading.verb, entry.key);
    for (const auto& inner : entries_in(reading, *entry.value->as_table(), table))
      in_tables.push_back({inner.key == "model" ? entry.key : inner.key, inner.value, table.name});
  }
  all.insert(all.end(), in_tables.begin(), in_tables.end());
  require_once(reading, all);
  return all;
}

/// Part of a value as text, "cloud-cover=1".
std::string part_of_region(const Reading& reading, const Entry& entry) {
  const auto where = reading.where(*entry.value) + entry.key;
  const auto text = as_text(*entry.value, where);
  if (text.empty() || text.find(',') != std::string::npos)
    throw algebra::Error(fmt::format("{} = '{}', allowed is a number or a word", where, text));
  return entry.key + "=" + text;
}

/// A table of parts as its flag spells it: "cloud-cover=1,from-latitude=-90,to-latitude=0".
std::string text_of_parts(const Reading& reading, const request::Parameter& grouped,
                          const toml::table& entries) {
  Table table{"a " + grouped.name, {}};
  for (const auto& part : *grouped.parts) table.keys.push_back(part.name);
  std::vector<std::string> parts;
  for (const auto& [key, value] : entries) {
    const Entry entry{std::string(key.str()), &value};
    require_key(reading, table, entry);
    parts.push_back(part_of_region(reading, entry));
  }
  auto text = fmt::format("{}", fmt::join(parts, ","));
  try {
    uses::region_from(text);
  } catch (const algebra::Error& error) {
    throw algebra::Error(reading.where(entries) + error.what());
  }
  return text;
}

/// Value of a parameter, or all values of one that may be given again.
std::vector<const toml::node*> values_of(const request::Parameter& parameter,
                                         const toml::node& value) {
  if (!value.is_array() || !parameter.many) return {&value};
  std::vector<const toml::node*> values;
  for (const auto& item : *value.as_array()) values.push_back(&item);
  return values;
}

/// `on` and `off` may be written true and false.
std::string spelt(const request::Parameter& parameter, const toml::node& value,
                  const std::string& text) {
  if (!value.is_boolean() || parameter.kind == request::Kind::presence) return text;
  return text == "true" ? "on" : "off";
}

/// `--key=value`, once for each value.
std::vector<std::string> flags_of(const Reading& reading, const Entry& entry) {
  const auto& parameter = *parameters_of(reading.verb).find(entry.key);
  std::vector<std::string> flags;
  for (const auto* value : values_of(parameter, *entry.value)) {
    const std::string where = reading.where(*value) + entry.key;
    const bool grouped = parameter.parts && value->is_table();
    std::string text = grouped ? text_of_parts(reading, parameter, *value->as_table())
                               : spelt(parameter, *value, as_text(*value, where));
    if (text.empty()) throw algebra::Error(where + ": is empty; leave it out instead");
    if (reading.lenient && parameter.kind == request::Kind::file_read)
      text = files::shared_file(text, reading.path);
    flags.push_back(fmt::format("--{}={}", entry.key, text));
  }
  return flags;
}

bool names(const std::vector<std::string>& arguments, const std::string& flag) {
  return std::any_of(arguments.begin(), arguments.end(), [&](const auto& argument) {
    return argument.substr(0, argument.find('=')) == "--" + flag;
  });
}

/// Flags that turn the recipe of a film, which is that of all its frames, into that of the file's own frame.
std::vector<std::string> frame_of_film(const Reading& reading, const toml::table& recipe,
                                       const std::vector<std::string>& mine) {
  const auto& verb = reading.verb;
  const auto flag_there = [&](const char* flag) {
    return verb.get_option_no_throw(std::string("--") + flag) != nullptr && !names(mine, flag);
  };
  const auto instant = reading.lenient && flag_there("instant") && !recipe.contains("instant")
                           ? texture::read_attribute(reading.path, "coppermoon:instant")
                           : std::nullopt;
  if (!instant) return {};
  std::vector<std::string> flags{"--instant=" + *instant};
  if (flag_there("calendar")) flags.emplace_back("--calendar=gregorian");
  const auto mount = recipe["mount"].value_or(std::string());
  if (mount == "fixed" && flag_there("up"))
    throw algebra::Error(fmt::format(
        "{}: shows where a fixed camera pointed, which `coppermoon animate` alone makes again",
        reading.path));
  if (mount == "horizon" && flag_there("up")) flags.emplace_back("--up=zenith");
  const auto time = recipe["time"].value_or(std::string());
  if (flag_there("time") && time.find(':') != std::string::npos)
    flags.push_back("--time=" +
                    texture::read_attribute(reading.path, "expTime").value_or("follow"));
  return flags;
}

}  // namespace

bool holds_recipe(const std::filesystem::path& path) {
  const auto ending = path.extension();
  return ending == ".exr" || ending == ".tx" || ending == ".png" ||
         path.filename() == std::filesystem::path(texture::stellarium_picture).filename();
}

std::vector<std::string> flags_of_recipe(const CLI::App& verb, const std::string& path,
                                         const std::vector<std::string>& mine) {
  const Reading reading{verb, path};
  const auto recipe = parsed(path);
  const auto all = entries_of(reading, recipe);
  std::vector<std::string> flags;
  for (const auto& entry : all)
    for (auto& flag : flags_of(reading, entry))
      if (!names(mine, entry.key)) flags.push_back(std::move(flag));
  const auto forget = [&](const std::string& name) {
    std::erase_if(flags, [&](const std::string& flag) { return flag.starts_with(name); });
  };
  for (const auto& own : frame_of_film(reading, recipe, mine)) {
    for (const std::string of_all : {"--from=", "--to="}) forget(of_all);
    forget(own.substr(0, own.find('=') + 1));
    flags.push_back(own);
  }
  return flags;
}

void warn_of_another_camera(const std::string& file, const std::optional<std::string>& response) {
  if (!response || !holds_recipe(file) || !texture::read_attribute(file, "coppermoon:recipe"))
    return;
  Verb recorded;
  std::optional<std::string> made_for;
  add_described(recorded, made_for, uses::describe_response);
  recorded.parse(flags_of_recipe(recorded, file, {}));
  if (made_for && colour::is_spectral(*made_for) && *made_for != *response)
    fmt::print(stderr,
               "coppermoon: {}: its colours are those of {}, not of {}: make it anew with "
               "--response {}\n",
               one_line(file), one_line(*made_for), one_line(*response), one_line(*response));
}

}  // namespace coppermoon::verbs
