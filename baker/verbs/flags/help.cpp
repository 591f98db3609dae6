// SPDX-License-Identifier: MIT
#include "verbs/flags/help.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "verbs/flags/guide.h"

namespace coppermoon::verbs {
namespace {

using request::Kind;

constexpr std::size_t page_columns = 88, text_column = 30;

std::string capitals(std::string text) {
  for (auto& letter : text)
    letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  return text;
}

std::string value_name(const request::Parameter& parameter) {
  if (parameter.kind == Kind::presence) return "";
  if (!parameter.words.empty()) return "WORD";
  if (is_number(parameter.kind)) return "NUMBER";
  if (parameter.kind == Kind::folder_written) return "FOLDER";
  return parameter.kind == Kind::file_read || is_written(parameter.kind) ? "FILE" : "TEXT";
}

/// Number of characters in a UTF-8 text.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char byte) { return (byte & 0xC0) != 0x80; }));
}

/// Wraps text to the width of the help page, and indents all lines after the first.
std::string wrapped(const std::string& text, std::size_t indent) {
  std::istringstream words(text);
  std::string lines, line;
  for (std::string word; words >> word;) {
    if (!line.empty() && indent + width_of(line) + 1 + width_of(word) > page_columns) {
      lines += line + "\n" + std::string(indent, ' ');
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return lines + line + "\n";
}

std::string row(const std::string& names, const std::string& text) {
  const bool fits = width_of(names) + 4 <= text_column;
  const auto gap = fits ? std::string(text_column - 2 - width_of(names), ' ')
                        : "\n" + std::string(text_column, ' ');
  return "  " + names + gap + wrapped(text, text_column);
}

std::string row(const FlagText& flag) {
  return row(flag.names + (flag.value.empty() ? "" : " " + flag.value), flag.text);
}

FlagText text_of(const request::Parameter& parameter) {
  FlagText flag{.name = parameter.name,
                .names = "--" + parameter.name,
                .value = value_name(parameter),
                .text = parameter.meaning,
                .group = parameter.heading.empty() ? "Options" : parameter.heading,
                .words = parameter.words,
                .positional = parameter.is_positional(),
                .required = parameter.is_required,
                .many = parameter.many};
  if (parameter.spelling.starts_with("-") && parameter.spelling[1] != '-')
    flag.names = parameter.spelling.substr(0, 2) + ", " + flag.names;
  const bool named = std::ranges::all_of(flag.words, [&](const std::string& word) {
    return flag.text.find(word) != std::string::npos;
  });
  if (!named) flag.text += fmt::format(": {}", fmt::join(flag.words, ", "));
  if (!parameter.usual.empty() && !flag.value.empty())
    flag.text += fmt::format(" (default {})", parameter.usual);
  return flag;
}

std::string examples_of(const Guide& guide) {
  std::string text = "\nExamples:\n";
  for (const auto example : guide.examples) text += fmt::format("  {}\n", example);
  return text;
}

std::string heading(const Verb& verb) {
  return fmt::format("coppermoon {} {}.\n\nUsage: coppermoon {}\n", verb.name, verb.help,
                     usage_of(verb));
}

}  // namespace

std::vector<FlagText> flag_texts(const Verb& verb) {
  std::vector<FlagText> flags;
  for (const auto* parameter : flags_of(verb)) flags.push_back(text_of(*parameter));
  return flags;
}

std::string usage_of(const Verb& verb) {
  std::string positional, required;
  for (const auto& flag : flag_texts(verb)) {
    const auto name = capitals(flag.name) + (flag.many ? "..." : "");
    if (flag.positional)
      positional += flag.required ? " " + name : " [" + name + "]";
    else if (flag.required)
      required += fmt::format(" {} {}", flag.names.substr(0, flag.names.find(',')), flag.value);
  }
  return fmt::format("{}{}{} [options]", verb.name, positional, required);
}

std::string short_help(const Verb& verb) {
  const auto& guide = guide_to(verb.name);
  const auto flags = flag_texts(verb);
  std::string text = heading(verb) + "\n";
  for (const auto& flag : flags)
    if (flag.positional) text += row(capitals(flag.name), flag.text);
  text += "\nCommon options:\n";
  for (const auto name : guide.common)
    if (const auto flag = std::ranges::find(flags, name, &FlagText::name); flag != flags.end())
      text += row(*flag);
  return text + examples_of(guide) +
         fmt::format("\n`coppermoon {} --help-all` lists all {} options.\n", verb.name,
                     flags.size());
}

std::string full_help(const Verb& verb) {
  const auto flags = flag_texts(verb);
  std::vector<std::string> groups;
  for (const auto& flag : flags)
    if (std::ranges::find(groups, flag.group) == groups.end()) groups.push_back(flag.group);
  std::string text = heading(verb);
  for (const auto& group : groups) {
    text += fmt::format("\n{}:\n", group);
    for (const auto& flag : flags)
      if (flag.group == group) text += row(flag);
  }
  return text + examples_of(guide_to(verb.name));
}

std::string program_help(const Program& program) {
  std::string text =
      "coppermoon bakes eclipsed Moons: textures, POV-Ray scenes, pictures and films of lunar "
      "eclipses.\n\nUsage: coppermoon COMMAND [options]\n";
  for (const auto& [name, guides] : guides()) {
    text += fmt::format("\n{}:\n", name);
    for (const auto& guide : guides)
      text += fmt::format("  {:<12}", guide.verb) +
              wrapped(std::ranges::find(program.verbs, guide.verb, &Verb::name)->help, 14);
  }
  return text +
         "\nA first picture:\n  coppermoon still 2018-07-27 --at Nairobi -o moon.png\n\n"
         "`coppermoon COMMAND --help` explains a command, `--help-all` lists all its options.\n"
         "`coppermoon --version` prints the version.\n";
}

}  // namespace coppermoon::verbs
