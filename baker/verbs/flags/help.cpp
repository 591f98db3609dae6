// SPDX-License-Identifier: MIT
#include "verbs/flags/help.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <sstream>

#include "verbs/flags/guide.h"

namespace coppermoon::verbs {
namespace {

constexpr std::size_t page_columns = 88, text_column = 30;

std::string capitals(std::string text) {
  for (auto& letter : text)
    letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  return text;
}

/// Words of CLI11's list "TEXT:{a,b}".
std::vector<std::string> words_in(const std::string& type) {
  const auto begin = type.find(":{"), end = type.rfind('}');
  std::vector<std::string> words;
  if (begin == std::string::npos || end == std::string::npos) return words;
  std::istringstream list(type.substr(begin + 2, end - begin - 2));
  for (std::string word; std::getline(list, word, ',');) words.push_back(word);
  return words;
}

std::string value_name(const std::string& type, const std::vector<std::string>& words) {
  if (!words.empty()) return "WORD";
  if (type.starts_with("NEW-FILE")) return "FILE";
  for (const char* numbers : {"FLOAT", "UINT", "INT"})
    if (type.starts_with(numbers)) return "NUMBER";
  return type.starts_with("FILE") || type.starts_with("FOLDER") ? type.substr(0, type.find(' '))
                                                                : "TEXT";
}

/// Number of characters of a UTF-8 text.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char byte) { return (byte & 0xC0) != 0x80; }));
}

/// Text wrapped to the page, its lines behind the first indented.
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

FlagText text_of(const CLI::Option& option) {
  const auto type = option.get_type_name();
  FlagText flag;
  flag.name = option.get_lnames().empty() ? "" : option.get_lnames().front();
  flag.text = option.get_description();
  flag.group = option.get_group();
  flag.words = words_in(type);
  flag.positional = option.get_positional();
  flag.required = option.get_required();
  for (const auto& name : option.get_snames()) flag.names += "-" + name + ", ";
  flag.names += "--" + flag.name;
  if (option.get_items_expected_max() > 0) flag.value = value_name(type, flag.words);
  const bool named = std::ranges::all_of(flag.words, [&](const std::string& word) {
    return flag.text.find(word) != std::string::npos;
  });
  if (!named) flag.text += fmt::format(": {}", fmt::join(flag.words, ", "));
  const auto usual = option.get_default_str();
  if (!usual.empty() && usual != "[]" && !flag.value.empty())
    flag.text += fmt::format(" (default {})", usual);
  return flag;
}

std::string examples_of(const Guide& guide) {
  std::string text = "\nExamples:\n";
  for (const auto example : guide.examples) text += fmt::format("  {}\n", example);
  return text;
}

std::string heading(const CLI::App& verb) {
  return fmt::format("coppermoon {} {}.\n\nUsage: coppermoon {}\n", verb.get_name(),
                     verb.get_description(), usage_of(verb));
}

}  // namespace

std::vector<FlagText> flag_texts(const CLI::App& verb) {
  std::vector<FlagText> flags;
  for (const auto* option : verb.get_options())
    if (!option->get_lnames().empty()) flags.push_back(text_of(*option));
  return flags;
}

std::string usage_of(const CLI::App& verb) {
  std::string positional, required;
  for (const auto* option : verb.get_options()) {
    if (option->get_lnames().empty()) continue;
    const auto flag = text_of(*option);
    const auto many = option->get_items_expected_max() > 1 ? "..." : "";
    if (flag.positional)
      positional += flag.required ? " " + capitals(flag.name) + many
                                  : " [" + capitals(flag.name) + many + "]";
    else if (flag.required)
      required += fmt::format(" {} {}", flag.names.substr(0, flag.names.find(',')), flag.value);
  }
  return fmt::format("{}{}{} [options]", verb.get_name(), positional, required);
}

std::string short_help(const CLI::App& verb) {
  const auto& guide = guide_to(verb.get_name());
  const auto flags = flag_texts(verb);
  std::string text = heading(verb) + "\n";
  for (const auto& flag : flags)
    if (flag.positional) text += row(capitals(flag.name), flag.text);
  text += "\nCommon options:\n";
  for (const auto name : guide.common)
    if (const auto flag = std::ranges::find(flags, name, &FlagText::name); flag != flags.end())
      text += row(*flag);
  return text + examples_of(guide) +
         fmt::format("\n`coppermoon {} --help-all` lists all {} options.\n", verb.get_name(),
                     flags.size());
}

std::string full_help(const CLI::App& verb) {
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
  return text + examples_of(guide_to(verb.get_name()));
}

std::string program_help(const CLI::App& program) {
  std::string text =
      "coppermoon bakes eclipsed Moons: textures, POV-Ray scenes, pictures and films of lunar "
      "eclipses.\n\nUsage: coppermoon COMMAND [options]\n";
  for (const auto& [name, guides] : guides()) {
    text += fmt::format("\n{}:\n", name);
    for (const auto& guide : guides)
      text += fmt::format("  {:<12}", guide.verb) +
              wrapped(program.get_subcommand(std::string(guide.verb))->get_description(), 14);
  }
  return text +
         "\nA first picture:\n  coppermoon still 2018-07-27 --at Nairobi -o moon.png\n\n"
         "`coppermoon COMMAND --help` explains a command, `--help-all` lists all its options.\n"
         "`coppermoon --version` prints the version.\n";
}

std::string help_called_for(const CLI::App& program, bool all) {
  const auto called = program.get_subcommands();
  if (called.empty()) return program_help(program);
  return all ? full_help(*called.front()) : short_help(*called.front());
}

}  // namespace coppermoon::verbs
