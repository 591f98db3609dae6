// SPDX-License-Identifier: MIT
#include "verbs/manuals/manual_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "uses/light/header.h"
#include "verbs/flags/guide.h"
#include "verbs/flags/help.h"

namespace coppermoon::verbs {
namespace {

/// Escapes text for roff.
std::string in_roff(std::string_view text) {
  std::string safe = text.starts_with('.') || text.starts_with('\'') ? "\\&" : "";
  for (const char letter : text)
    if (letter == '\\')
      safe += "\\e";
    else if (letter == '-')
      safe += "\\-";
    else
      safe += letter;
  return safe;
}

std::string title(std::string name) {
  std::ranges::transform(name, name.begin(), [](unsigned char letter) {
    return static_cast<char>(std::toupper(letter));
  });
  return fmt::format(".TH {0} 1 \"\" \"coppermoon {1}\" \"coppermoon\"\n", in_roff(name),
                     uses::version());
}

std::string bold(std::string_view text) { return "\\fB" + in_roff(text) + "\\fR"; }

std::string option_of(const FlagText& flag) {
  const auto value = flag.value.empty() ? std::string() : " \\fI" + in_roff(flag.value) + "\\fR";
  return fmt::format(".TP\n{}{}\n{}\n", bold(flag.names), value, in_roff(flag.text));
}

std::string options_of(const Verb& verb) {
  const auto flags = flag_texts(verb);
  std::vector<std::string> groups;
  for (const auto& flag : flags)
    if (std::ranges::find(groups, flag.group) == groups.end()) groups.push_back(flag.group);
  std::string text = ".SH OPTIONS\n";
  for (const auto& group : groups) {
    text += fmt::format(".SS {}\n", in_roff(group));
    for (const auto& flag : flags)
      if (flag.group == group) text += option_of(flag);
  }
  return text;
}

std::string example(std::string_view line) {
  return fmt::format(".PP\n.RS 4\n.nf\n{}\n.fi\n.RE\n", in_roff(line));
}

constexpr const char* exit_status =
    ".SH EXIT STATUS\n.TP\n0\ndone\n.TP\n1\nnot possible: one line on standard error says why\n"
    ".TP\n2\nwrong usage: one line on standard error says what is allowed\n";

}  // namespace

std::string manual_page(const Verb& verb) {
  const auto& name = verb.name;
  std::string text = title("coppermoon-" + name);
  text += fmt::format(".SH NAME\n{} \\- {}\n.SH SYNOPSIS\n{}\n", in_roff("coppermoon-" + name),
                      in_roff(verb.help), bold("coppermoon " + usage_of(verb)));
  text += options_of(verb) + ".SH EXAMPLES\n";
  for (const auto line : guide_to(name).examples) text += example(line);
  return text + exit_status + ".SH SEE ALSO\n.BR coppermoon (1)\n";
}

std::string program_manual_page(const Program& program) {
  std::string text = title("coppermoon");
  text +=
      ".SH NAME\ncoppermoon \\- bakes eclipsed Moons\n.SH SYNOPSIS\n.B coppermoon\n"
      ".I COMMAND\n[options]\n.SH DESCRIPTION\n"
      "coppermoon makes textures, POV\\-Ray scenes, pictures and films of lunar eclipses, lit by "
      "the sunlight that the Earth's air bends into its shadow.\n.PP\n"
      "A recipe, a TOML file of options without their dashes, holds what a command is told; every "
      "file that coppermoon makes holds its own.\n.SH COMMANDS\n";
  std::string also;
  for (const auto& verb : program.verbs) {
    text += fmt::format(".TP\n{}\n{}\n", bold(verb.name), in_roff(verb.help));
    also +=
        fmt::format("{}.BR {} (1)", also.empty() ? "" : " ,\n", in_roff("coppermoon-" + verb.name));
  }
  text +=
      ".SH OPTIONS\n.TP\n\\fB\\-\\-help\\fR\nlists the commands; behind a command, its common "
      "options\n.TP\n\\fB\\-\\-help\\-all\\fR\nbehind a command: lists all its options\n.TP\n"
      "\\fB\\-\\-version\\fR\nprints the version\n";
  return text + exit_status + ".SH SEE ALSO\n" + also + "\n";
}

}  // namespace coppermoon::verbs
