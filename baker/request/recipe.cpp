// SPDX-License-Identifier: MIT
#include "request/recipe.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <sstream>
#include <string_view>
#include <utility>

#include "files/name_to_share.h"

namespace coppermoon::request {
namespace {

/// Text as a quoted TOML string on a single line.
std::string quoted(const std::string& text) {
  const bool plain = std::ranges::none_of(text, [](char c) { return c >= 0 && c < ' '; });
  std::ostringstream literal;
  literal << toml::toml_formatter{
      toml::value{text}, plain ? toml::toml_formatter::default_flags : toml::format_flags::none};
  return literal.str();
}

/// Whether TOML can hold a value without quotes. Integers must be below 2^63; fractions such as 24000/1001 need quotes.
bool is_bare(const Parameter& parameter, const std::string& text) {
  if (parameter.kind == Kind::presence) return true;
  if (parameter.name == "field") return fault_in(Kind::number, text).empty();  // words need quotes
  return is_number(parameter.kind) && fault_in(parameter.kind, text).empty() &&
         !(parameter.kind == Kind::natural && std::stoull(text) >> 63);
}

Setting setting_of(const Parameter& parameter) {
  Setting setting{.name = parameter.name, .table = parameter.table, .affects = parameter.affects};
  for (const auto& text : parameter.texts()) {
    if (parameter.parts) {
      take_parts(*parameter.parts, text);
      setting.parts.push_back(recipe_of(
          *parameter.parts, [](const Parameter& part) { return part.given.has_value(); }));
      continue;
    }
    setting.bare = is_bare(parameter, text);
    const auto kind = setting.bare && parameter.name == "field" ? Kind::number : parameter.kind;
    setting.texts.push_back(kind == Kind::file_read ? files::name_to_share(text)
                            : setting.bare          ? spelt(kind, text)
                                                    : text);
  }
  return setting;
}

std::string value_of(const Setting& setting) {
  std::vector<std::string> values;
  for (const auto& text : setting.texts) values.push_back(setting.bare ? text : quoted(text));
  return values.size() == 1 ? values[0] : fmt::format("[{}]", fmt::join(values, ", "));
}

/// A setting's value as shown to users, such as "300" or, if it has parts, "from-latitude = -90; to-latitude = 0".
std::string in_words(const Setting& setting) {
  std::vector<std::string> words;
  for (const auto& value : setting.parts)
    for (const auto& part : value) words.push_back(part.name + " = " + value_of(part));
  if (!setting.has_value()) return "none";
  return words.empty() ? value_of(setting) : fmt::format("{}", fmt::join(words, "; "));
}

std::string line_of(const Setting& setting) {
  return setting.texts.empty() ? "" : fmt::format("{} = {}\n", setting.name, value_of(setting));
}

std::string text_of(const toml::node& value, const std::string& where) {
  if (const auto* word = value.as_string()) {
    if (word->get().find('\0') != std::string::npos)
      throw algebra::Error(fmt::format("{}: holds a zero byte, allowed is text without", where));
    return word->get();
  }
  if (const auto* integer = value.as_integer()) return fmt::format("{}", integer->get());
  if (const auto* number = value.as_floating_point()) return fmt::format("{}", number->get());
  if (const auto* truth = value.as_boolean()) return truth->get() ? "true" : "false";
  std::ostringstream text;
  if (const auto* when = value.as_date_time())
    text << when->get();
  else if (const auto* list = value.as_array())
    for (const auto& item : *list) text << (text.tellp() > 0 ? "," : "") << text_of(item, where);
  else
    throw algebra::Error(
        fmt::format("{}: allowed are texts, numbers, dates, true, false and lists", where));
  return text.str();
}

std::string where_is(const toml::node& value, const std::string& file) {
  return file.empty() ? "" : fmt::format("{}:{}: ", file, value.source().begin.line);
}

Recipe settings_in(const toml::table& entries, const std::string& file, const std::string& table);

Setting setting_in(const std::string& name, const toml::node& value, const std::string& file) {
  Setting setting{.name = name, .where = where_is(value, file)};
  const auto add = [&](const toml::node& one) {
    if (const auto* parts = one.as_table()) {
      auto part = settings_in(*parts, file, "");
      setting.parts.push_back(std::move(part));
    } else {
      setting.texts.push_back(text_of(one, setting.where + name));
    }
  };
  setting.bare = value.is_number() || value.is_boolean();
  if (const auto* list = value.as_array(); list && !list->empty())
    for (const auto& item : *list) add(item);
  else
    add(value);
  return setting;
}

Recipe settings_in(const toml::table& entries, const std::string& file, const std::string& table) {
  Recipe all;
  for (const auto& [key, value] : entries) {
    auto setting = setting_in(std::string(key.str()), value, file);
    setting.table = table;
    if (!table.empty() && setting.name == "model") setting.name = table;
    all.push_back(std::move(setting));
  }
  return all;
}

/// Length of the quoted TOML string at the start of the given text [bytes], including its single or triple quotes.
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

/// Length of the first token in the given text [bytes]. A token is a quoted string, a comment, or a single character.
std::size_t token_length(std::string_view text) {
  if (text.front() == '"' || text.front() == '\'') return quoted_length(text);
  return text.front() == '#' ? std::min(text.find('\n'), text.size()) : 1;
}

/// Refuses names with many parts. A name such as `a.b.c` makes nested tables, which toml++ visits by recursion, so that
/// too many parts would overflow the stack.
void require_short_names(const std::string& file, std::string_view text) {
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
                                       file, line, most_parts, most_parts));
  }
}

toml::table parsed(const std::string& text, const std::string& file) {
  constexpr std::size_t most_bytes = 1 << 20;
  if (text.size() > most_bytes)
    throw algebra::Error(
        fmt::format("{}: a recipe of more than {} bytes, allowed up to that", file, most_bytes));
  require_short_names(file, text);
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    throw algebra::Error(
        fmt::format("{}:{}: {}", file, error.source().begin.line, error.description()));
  }
}

/// Removes a setting from a recipe's text and returns it. Expects a value without quotes that runs to the end of the
/// line.
Setting taken_from(std::string& text, const std::string& name) {
  const auto key = name + " = ";
  auto begin = text.starts_with(key) ? 0 : text.find("\n" + key);
  if (begin == std::string::npos) return {.name = name};
  begin += text[begin] == '\n' ? 1 : 0;
  const auto end = std::min(text.find('\n', begin), text.size());
  const auto value = text.substr(begin + key.size(), end - begin - key.size());
  text.erase(begin, end - begin);
  return {.name = name, .texts = {value}, .bare = true};
}

bool alike(const Setting& a, const Setting& b) {
  return a.texts == b.texts &&
         std::ranges::equal(a.parts, b.parts, [](const Recipe& one, const Recipe& other) {
           return differences(one, other).empty();
         });
}

}  // namespace

Recipe recipe_of(const Parameters& parameters,
                 const std::function<bool(const Parameter&)>& chosen) {
  Recipe recipe;
  for (const auto& parameter : parameters)
    if (chosen(parameter)) recipe.push_back(setting_of(parameter));
  return recipe;
}

std::string text_of(const Recipe& recipe) {
  std::string lines, tables, model;
  for (const auto& setting : recipe) {
    if (setting.parts.empty()) continue;
    model = setting.table;
    if (const auto* own = setting_in(recipe, model))
      tables += fmt::format("\n[{}]\nmodel = {}\n", model, value_of(*own));
    for (const auto& value : setting.parts) {
      tables += fmt::format("\n[[{}.{}]]\n", setting.table, setting.name);
      for (const auto& part : value) tables += line_of(part);
    }
  }
  for (const auto& setting : recipe)
    if (setting.parts.empty() && setting.name != model) lines += line_of(setting);
  return lines + tables;
}

Recipe recipe_in(std::string text, const std::string& file, const Texts& bare) {
  Recipe all, in_tables;
  for (const auto& name : bare) all.push_back(taken_from(text, name));
  for (const auto& [key, value] : parsed(text, file)) {
    const std::string name(key.str());
    auto& settings = value.is_table() ? in_tables : all;
    auto more = value.is_table() ? settings_in(*value.as_table(), file, name)
                                 : Recipe{setting_in(name, value, file)};
    std::ranges::move(more, std::back_inserter(settings));
  }
  for (auto& setting : in_tables) {
    if (setting_in(all, setting.name) != nullptr)
      throw algebra::Error(fmt::format("{}{}: given twice, above all tables and in [{}]",
                                       setting.where, setting.name, setting.table));
    all.push_back(std::move(setting));
  }
  return all;
}

const Setting* setting_in(const Recipe& recipe, const std::string& name) {
  const auto found = std::ranges::find(recipe, name, &Setting::name);
  return found == recipe.end() ? nullptr : &*found;
}

Recipe with(std::vector<Setting> values, const Recipe& recipe) {
  for (const auto& setting : recipe) {
    const auto found = std::ranges::find(values, setting.name, &Setting::name);
    if (found == values.end())
      values.push_back(setting);
    else
      found->affects = setting.affects;
  }
  return values;
}

std::vector<Difference> differences(const Recipe& first, const Recipe& second,
                                    const std::function<bool(const Setting&)>& counts) {
  std::vector<Difference> all;
  const auto compare = [&](const Setting& a, const Setting& b) {
    if (!alike(a, b))
      all.push_back({a.name, in_words(a), in_words(b), !a.parts.empty() || !b.parts.empty()});
  };
  for (const auto& setting : first) {
    const auto* other = setting_in(second, setting.name);
    if (counts(other ? *other : setting)) compare(setting, other ? *other : Setting{});
  }
  for (const auto& setting : second)
    if (setting_in(first, setting.name) == nullptr && counts(setting))
      compare({.name = setting.name}, setting);
  return all;
}

}  // namespace coppermoon::request
