// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <cstdio>
#include "support/testing.h"

#include "../../texture/scratch_folder.h"
#include "support/testing.h"
#include "verbs/command_line.h"
#include "verbs/flags/help.h"
#include "verbs/manuals/completions.h"
#include "verbs/manuals/manual_page.h"

namespace coppermoon::verbs::manuals_test {

/// What a command prints on both its outputs, and its status where that is not 0.
std::string printed_by(const std::string& command) {
  auto* output = ::popen((command + " 2>&1").c_str(), "r");
  std::string text;
  std::array<char, 4096> part{};
  while (const auto count = std::fread(part.data(), 1, part.size(), output))
    text.append(part.data(), count);
  const int status = ::pclose(output);
  return status == 0 ? text : text + fmt::format("[status {}]", status);
}

class Manuals : public ScratchFolder {
 protected:
  Manuals() { add_verbs(program); }

  /// What bash offers behind words of a command line, the last of which is being typed.
  std::string offered(const std::string& words, int count) const {
    file("coppermoon.bash", bash_completion(program));
    file("frame.exr", "");
    return printed_by(
        fmt::format("cd {} && bash -c '. ./coppermoon.bash; COMP_WORDS=({}); COMP_CWORD={}; "
                    "_coppermoon; echo \"${{COMPREPLY[*]}}\"'",
                    in_folder("").string(), words, count - 1));
  }

  Program program;
};

TEST_F(Manuals, PagesHoldEveryOptionAndGroffHasNothingToWarnOf) {
  std::vector<std::string> pages{file("coppermoon.1", program_manual_page(program)).string()};
  for (const auto& verb : program.verbs) {
    const auto page = manual_page(verb);
    pages.push_back(file(verb.name + ".1", page).string());
    for (const auto& flag : flag_texts(verb)) {
      auto name = "--" + flag.name;
      for (std::size_t at = 0; (at = name.find('-', at)) != std::string::npos; at += 2)
        name.replace(at, 1, "\\-");
      EXPECT_SAYS(page, name) << verb.name << ' ' << name;
    }
  }
  for (const auto& page : pages)
    EXPECT_EQ(printed_by(fmt::format("groff -K utf8 -T utf8 -man -ww -z {}", page)), "") << page;
}

TEST_F(Manuals, RoffPrintsTextsAsTheyAre) {
  Program app;
  auto& verb = add_verb(app, "shoot", "takes 'all' of C:\\x");
  bool given = false;
  add_switch(verb, "--so", given, ".TH is no macro here, - is a minus, \\n no new line");
  const auto page = file("shoot.1", manual_page(verb));
  const auto shown = printed_by(
      fmt::format("groff -K utf8 -T ascii -P -cbou -man -ww -rLL=200n {}", page.string()));
  EXPECT_SAYS(shown, ".TH is no macro here, - is a minus, \\n no new line");
  EXPECT_SAYS(shown, "takes 'all' of C:\\x");
}

TEST_F(Manuals, ShellsReadTheirCompletions) {
  const auto bash = file("a.bash", bash_completion(program)),
             zsh = file("a.zsh", zsh_completion(program)),
             fish = file("a.fish", fish_completion(program));
  EXPECT_EQ(printed_by("bash -n " + bash.string()), "");
  EXPECT_EQ(printed_by("zsh -n " + zsh.string()), "");
  EXPECT_EQ(printed_by("fish --no-execute " + fish.string()), "");
}

TEST_F(Manuals, BashCompletesCommandsOptionsWordsAndFiles) {
  EXPECT_EQ(offered("coppermoon sti", 2), "still\n");
  EXPECT_EQ(offered("coppermoon s", 2), "sky shadow shader scene still\n");
  EXPECT_EQ(offered("coppermoon still --qual", 3), "--quality\n");
  EXPECT_EQ(offered("coppermoon still --quality dr", 4), "draft\n");
  EXPECT_EQ(offered("coppermoon still --quality = dr", 5), "draft\n");
  EXPECT_EQ(offered("coppermoon still --albedo-map fr", 4), "frame.exr\n");
  EXPECT_EQ(offered("coppermoon develop fr", 3), "frame.exr\n");
  EXPECT_EQ(offered("coppermoon still --width fr", 4), "\n");
  EXPECT_EQ(offered("coppermoon sky --qual", 3), "\n");
}

TEST_F(Manuals, FishCompletesAsWell) {
  const auto script = file("a.fish", fish_completion(program));
  const auto completed = [&](const std::string& line) {
    return printed_by(
        fmt::format("HOME={} fish --no-config -c \"source {}; complete -C '{}'\" | cut -f1",
                    in_folder("").string(), script.string(), line));
  };
  EXPECT_EQ(completed("coppermoon sti"), "still\n");
  EXPECT_EQ(completed("coppermoon still --quality dr"), "draft\n");
  EXPECT_EQ(completed("coppermoon still --qual"), "--quality\n");
}

}  // namespace coppermoon::verbs::manuals_test
