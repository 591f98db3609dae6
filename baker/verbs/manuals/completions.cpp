// SPDX-License-Identifier: MIT
#include "verbs/manuals/completions.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

#include "verbs/flags/help.h"
#include "verbs/reports/one_line.h"

namespace coppermoon::verbs {
namespace {

/// A command of the program, its description, and its flags.
struct Command {
  std::string name, text;
  std::vector<FlagText> flags;
};

std::vector<Command> commands_of(const Program& program) {
  std::vector<Command> all;
  for (const auto& verb : program.verbs) all.push_back({verb.name, verb.help, flag_texts(verb)});
  return all;
}

/// All spellings of a flag: for example, "-o" and "--output".
std::vector<std::string> spellings(const FlagText& flag) {
  std::string names = flag.names;
  std::erase(names, ',');
  std::istringstream words(names);
  std::vector<std::string> all;
  for (std::string word; words >> word;) all.push_back(word);
  return all;
}

bool names_files(const FlagText& flag) { return flag.value == "FILE" || flag.value == "FOLDER"; }

bool takes_files(const Command& command) {
  return std::ranges::any_of(command.flags, [](const FlagText& flag) {
    return flag.positional && (names_files(flag) || flag.name == "instant");
  });
}

/// The beginning of a help text, up to its first punctuation mark, for display beside an option.
std::string brief(const std::string& text) {
  auto end = text.size();
  for (const char* stop : {": ", "; ", ". ", " ("}) end = std::min(end, text.find(stop));
  return text.substr(0, end);
}

std::string escaped(const std::string& text, std::string_view special) {
  std::string safe;
  for (const char letter : text) {
    if (special.find(letter) != std::string_view::npos) safe += '\\';
    safe += letter;
  }
  return safe;
}

std::string bash_values(const Command& command) {
  std::string nothing, files, text;
  for (const auto& flag : command.flags) {
    if (flag.value.empty()) continue;
    std::vector<std::string> pattern;
    for (const auto& name : spellings(flag)) pattern.push_back(command.name + "," + name);
    if (!flag.words.empty())
      text += fmt::format("    {}) words=\"{}\" ;;\n", fmt::join(pattern, " | "),
                          fmt::join(flag.words, " "));
    else
      (names_files(flag) ? files : nothing) += fmt::format(" | {}", fmt::join(pattern, " | "));
  }
  if (!files.empty()) text += fmt::format("    {}) files=yes ;;\n", files.substr(3));
  if (!nothing.empty()) text += fmt::format("    {}) return ;;\n", nothing.substr(3));
  return text;
}

std::string bash_flags(const Command& command) {
  std::vector<std::string> all;
  for (const auto& flag : command.flags)
    for (const auto& name : spellings(flag)) all.push_back(name);
  return fmt::format("      {}) words=\"{}\" ;;\n", command.name, fmt::join(all, " "));
}

std::string zsh_flag(const FlagText& flag) {
  std::string text;
  for (const auto& name : spellings(flag)) {
    auto spec = "*" + name;
    if (!flag.value.empty()) spec += name.starts_with("--") ? "=" : "+";
    spec += "[" + escaped(brief(flag.text), "[]:\\") + "]";
    if (!flag.words.empty())
      spec += fmt::format(":{}:({})", flag.value, fmt::join(flag.words, " "));
    else if (!flag.value.empty())
      spec += fmt::format(":{}:{}", flag.value, names_files(flag) ? "_files" : " ");
    text += " \\\n        " + in_single_quotes(spec);
  }
  return text;
}

std::string fish_text(const std::string& text) { return "'" + escaped(text, "'\\") + "'"; }

std::string fish_flag(const Command& command, const FlagText& flag) {
  std::string line =
      fmt::format("complete -c coppermoon -n '__fish_seen_subcommand_from {}'", command.name);
  for (const auto& name : spellings(flag))
    line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (!flag.words.empty())
    line += fmt::format(" -x -a '{}'", fmt::join(flag.words, " "));
  else if (!flag.value.empty())
    line += names_files(flag) ? " -r -F" : " -x";
  return line + " -d " + fish_text(brief(flag.text)) + "\n";
}

}  // namespace

std::string bash_completion(const Program& program) {
  std::string names, values, flags, with_files;
  for (const auto& command : commands_of(program)) {
    names += (names.empty() ? "" : " ") + command.name;
    values += bash_values(command);
    flags += bash_flags(command);
    if (takes_files(command)) with_files += (with_files.empty() ? "" : " | ") + command.name;
  }
  return "# bash completion of coppermoon\n"
         "_coppermoon() {\n"
         "  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}\n"
         "  local command=${COMP_WORDS[1]} words= files=\n"
         "  if [[ $current == = ]]; then\n    current=\n"
         "  elif [[ $previous == = ]]; then\n    previous=${COMP_WORDS[COMP_CWORD - 2]}\n  fi\n"
         "  COMPREPLY=()\n"
         "  case $command,$previous in\n" +
         values +
         "  esac\n"
         "  if ((COMP_CWORD == 1)); then\n    words=\"" +
         names +
         " --help --version\"\n"
         "  elif [[ -z $words$files && $current == -* ]]; then\n    case $command in\n" +
         flags +
         "    esac\n"
         "  elif [[ -z $words$files ]]; then\n    case $command in\n      " +
         with_files +
         ") files=yes ;;\n    esac\n  fi\n"
         "  if [[ -n $files ]]; then\n"
         "    compopt -o filenames 2>/dev/null\n"
         "    mapfile -t COMPREPLY < <(compgen -f -- \"$current\")\n"
         "  else\n"
         "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\")\n"
         "  fi\n"
         "}\n"
         "complete -F _coppermoon coppermoon\n";
}

std::string zsh_completion(const Program& program) {
  std::string names, cases;
  for (const auto& command : commands_of(program)) {
    names += "    " + in_single_quotes(command.name + ":" + escaped(command.text, ":\\")) + "\n";
    cases += "    " + command.name + ")\n      _arguments";
    for (const auto& flag : command.flags) cases += zsh_flag(flag);
    cases += takes_files(command) ? " \\\n        '*:file:_files' ;;\n" : " ;;\n";
  }
  return "#compdef coppermoon\n"
         "_coppermoon() {\n"
         "  local -a commands=(\n" +
         names +
         "  )\n"
         "  if ((CURRENT == 2)); then\n"
         "    _describe -t commands 'coppermoon command' commands\n    return\n  fi\n"
         "  shift words\n  ((CURRENT--))\n  case $words[1] in\n" +
         cases + "  esac\n}\n_coppermoon \"$@\"\n";
}

std::string fish_completion(const Program& program) {
  std::string text = "# fish completion of coppermoon\ncomplete -c coppermoon -f\n";
  for (const auto& command : commands_of(program)) {
    text += fmt::format("complete -c coppermoon -n __fish_use_subcommand -a {} -d {}\n",
                        command.name, fish_text(command.text));
    if (takes_files(command))
      text += fmt::format("complete -c coppermoon -n '__fish_seen_subcommand_from {}' -F\n",
                          command.name);
    for (const auto& flag : command.flags) text += fish_flag(command, flag);
  }
  return text;
}

}  // namespace coppermoon::verbs
