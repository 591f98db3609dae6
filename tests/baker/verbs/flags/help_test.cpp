// SPDX-License-Identifier: MIT
#include "verbs/flags/help.h"

#include "support/testing.h"

#include "support/testing.h"
#include "verbs/command_line.h"
#include "verbs/flags/guide.h"
#include "verbs/flags/known_words.h"

namespace coppermoon::verbs::help_test {

/// Commands with their parameters.
struct AllCommands : Program {
  AllCommands() { add_verbs(*this); }
};

std::vector<std::string> split(const std::string& line) {
  std::istringstream words(line);
  return {std::istream_iterator<std::string>(words), {}};
}

TEST(Guides, ThereIsOneToEachVerb) {
  AllCommands program;
  std::multiset<std::string> guided, verbs;
  for (const auto& group : guides())
    for (const auto& guide : group.guides) guided.insert(std::string(guide.verb));
  for (auto& verb : program.verbs) verbs.insert(verb.name);
  EXPECT_EQ(guided, verbs);
}

TEST(Guides, NameFlagsThatThereAreAndFewOfThem) {
  AllCommands program;
  for (auto& verb : program.verbs) {
    const auto known = names_of(verb);
    const auto& common = guide_to(verb.name).common;
    EXPECT_LE(common.size(), 10U) << verb.name;
    for (const auto flag : common) EXPECT_TRUE(holds(known, flag)) << verb.name << " --" << flag;
  }
}

TEST(Guides, HaveTwoExamplesOfFlagsThatThereAre) {
  AllCommands program;
  for (auto& verb : program.verbs) {
    const auto& examples = guide_to(verb.name).examples;
    EXPECT_EQ(examples.size(), 2U) << verb.name;
    for (const auto example : examples) {
      const auto words = split(std::string(example));
      ASSERT_GT(words.size(), 2U);
      EXPECT_EQ(words[0], "coppermoon");
      EXPECT_EQ(words[1], verb.name);
      for (const auto& word : words)
        if (word.starts_with("-")) {
          EXPECT_NE(flag_of(verb, word.starts_with("--") ? word.substr(2) : word), nullptr)
              << example;
        }
    }
  }
}

TEST(Help, OfAllListsEachFlagOnceInSentencesThatSayWhatItIs) {
  AllCommands program;
  for (auto& verb : program.verbs) {
    const auto help = full_help(verb);
    for (const auto& flag : flag_texts(verb)) {
      EXPECT_SAYS(help, flag.names) << verb.name << flag.names;
      EXPECT_GT(flag.text.size(), 10U) << flag.name;
      for (const char* bare : {"of ", "on or off", "as ", "by ", "its ", "that ", "without: "})
        EXPECT_FALSE(flag.text.starts_with(bare)) << flag.name << ": " << flag.text;
    }
  }
}

TEST(Help, LinesEndBeforeThePageDoes) {
  AllCommands program;
  for (auto& verb : program.verbs) {
    std::istringstream lines(full_help(verb));
    for (std::string line; std::getline(lines, line);)
      if (!line.starts_with("coppermoon") && !line.starts_with("  coppermoon")) {
        EXPECT_LE(std::ranges::count_if(line, [](char c) { return (c & 0xC0) != 0x80; }), 88)
            << line;
      }
  }
}

TEST(Suggestions, AreWhatIsMeantOrAlmostSpelt) {
  AllCommands program;
  const auto flags = names_of(*find_verb(program, "still"));
  EXPECT_EQ(flag_suggested_for("fov", flags), "; did you mean --field?");
  EXPECT_EQ(flag_suggested_for("exposure", flags), "; did you mean --time?");
  EXPECT_EQ(flag_suggested_for("widht", flags), "; did you mean --width?");
  EXPECT_EQ(flag_suggested_for("verbose", flags), "");
  EXPECT_TRUE(
      flag_suggested_for("precision", flags).starts_with("; photons are no longer marched"));
  EXPECT_EQ(flag_suggested_for("xyz", flags), "");
  EXPECT_EQ(flag_suggested_for(std::string(100000, 'x'), flags), "");
  EXPECT_EQ(verb_suggested_for("render", {"still", "ring"}), "; did you mean still?");
  EXPECT_EQ(verb_suggested_for("stil", {"still", "ring"}), "; did you mean still?");
  EXPECT_EQ(verb_suggested_for("develope", {"still", "ring"}), "");
}

TEST(Suggestions, LeadFromNaturalWordsToFlagsAndCommands) {
  AllCommands program;
  const auto flags_of = [&](const char* verb) { return names_of(*find_verb(program, verb)); };
  EXPECT_EQ(flag_suggested_for("width", flags_of("bake")), "; did you mean --texture-width?");
  EXPECT_EQ(flag_suggested_for("resolution", flags_of("bake")), "; did you mean --texture-width?");
  EXPECT_EQ(flag_suggested_for("resolution", flags_of("still")), "; did you mean --width?");
  EXPECT_EQ(flag_suggested_for("latitude", flags_of("still")), "; did you mean --at?");
  EXPECT_EQ(flag_suggested_for("date", flags_of("still")), "; did you mean --instant?");
  EXPECT_EQ(flag_suggested_for("date", flags_of("animate")), "; did you mean --eclipse?");
  EXPECT_EQ(flag_suggested_for("tz", flags_of("night")), "; did you mean --zone?");
  EXPECT_EQ(verb_suggested_for("tonight", {"still", "night"}), "; did you mean night?");
  EXPECT_EQ(verb_suggested_for("panorama", {"still", "dome"}), "; did you mean dome?");
}

TEST(Help, IsAWordOfTheProgramToo) {
  const auto text = [](const std::vector<std::string>& words) {
    AllCommands program;
    return asked_by(program, words).text;
  };
  EXPECT_EQ(text({"help"}), text({"--help"}));
  EXPECT_NE(text({"help"}).find("Usage: coppermoon COMMAND"), std::string::npos);
  EXPECT_NE(text({"help", "still"}).find("Usage: coppermoon still"), std::string::npos);
  for (const auto& words : std::vector<std::vector<std::string>>{{"still", "--help"},
                                                                 {"still", "-h"},
                                                                 {"--help", "still"},
                                                                 {"still", "--iso", "x", "-h"}})
    EXPECT_EQ(text(words), text({"help", "still"}));
  EXPECT_NE(text({"still", "--help-all"}), text({"still", "--help"}));
  EXPECT_TRUE(text({"version"}).starts_with("coppermoon "));
  EXPECT_EQ(text({"version"}), text({"--version"}));
  EXPECT_THROW(text({"help", "stil"}), WrongUsage);
}

}  // namespace coppermoon::verbs::help_test
