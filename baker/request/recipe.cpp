// SPDX-License-Identifier: MIT
#include "request/recipe.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "files/name_to_share.h"

namespace coppermoon::request {
namespace {

bool is_control(char c) { return (c >= 0 && c < ' ') || c == '\x7F'; }

std::string toml_value(const Parameter& parameter) {
  const auto text = parameter.text();
  if (text.empty()) return {};
  if (parameter.kind == Kind::file_read) return quoted(files::name_to_share(text));
  if (parameter.kind == Kind::presence) return "true";
  if (parameter.name == "field" && fault_in(Kind::number, text).empty())
    return spelt(Kind::number, text);  // a number, or "moon"
  if (!is_number(parameter.kind)) return quoted(text);
  const bool too_large = parameter.kind == Kind::natural && std::stoull(text) >> 63,
             ratio = !fault_in(parameter.kind, text).empty();  // as 24000/1001
  return too_large || ratio ? quoted(text)
                            : spelt(parameter.kind, text);  // TOML's own integers end at 2^63
}

/// Values with parts as tables in the table of the parameter, whose own name is `model` there.
std::string tables_of(const Parameters& parameters, const Parameter& grouped) {
  const auto texts = grouped.texts();
  if (texts.empty()) return {};
  auto text = fmt::format("\n[{}]\nmodel = {}\n", grouped.table,
                          toml_value(*parameters.find(grouped.table)));
  for (const auto& value : texts) {
    text += fmt::format("\n[[{}.{}]]\n", grouped.table, grouped.name);
    take_parts(*grouped.parts, value);
    for (const auto& part : *grouped.parts)
      if (part.given) text += recipe_line(part);
  }
  return text;
}

/// Flags of a recipe with their values, in order; all regions of the air are one entry.
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

}  // namespace

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

std::string recipe_line(const Parameter& parameter) {
  const auto value = toml_value(parameter);
  return value.empty() ? "" : parameter.name + " = " + value + "\n";
}

std::string recipe_of(const Parameters& parameters,
                      const std::function<bool(const Parameter&)>& chosen) {
  std::string tables, lines;
  for (const auto& parameter : parameters)
    if (parameter.parts && chosen(parameter)) tables += tables_of(parameters, parameter);
  for (const auto& parameter : parameters) {
    if (parameter.parts || !chosen(parameter)) continue;
    if (!tables.empty() && tables.starts_with("\n[" + parameter.name + "]")) continue;
    lines += recipe_line(parameter);
  }
  return lines + tables;
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

std::vector<Difference> differences(const std::string& first, const std::string& second) {
  const auto a = lines_of(first), b = lines_of(second);
  std::vector<Difference> all;
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

}  // namespace coppermoon::request
