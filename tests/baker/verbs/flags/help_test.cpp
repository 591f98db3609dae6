// SPDX-License-Identifier: MIT
#include "verbs/flags/help.h"

#include <CLI/CLI.hpp>

#include "support/testing.h"
#include "verbs/command_line.h"
#include "verbs/flags/guide.h"
#include "verbs/flags/known_words.h"
#include "verbs/flags/plain_error.h"
#include "verbs/recipes/recipe_file.h"

namespace coppermoon::verbs {
namespace {

struct Program {
  CLI::App app{"", "coppermoon"};
  Program() { add_words(app); }

  std::vector<CLI::App*> verbs() { return app.get_subcommands({}); }
};

std::vector<std::string> split(const std::string& line) {
  std::istringstream words(line);
  return {std::istream_iterator<std::string>(words), {}};
}

TEST(Guides, ThereIsOneToEachVerb) {
  Program program;
  std::multiset<std::string> guided, verbs;
  for (const auto& group : guides())
    for (const auto& guide : group.guides) guided.insert(std::string(guide.verb));
  for (const auto* verb : program.verbs()) verbs.insert(verb->get_name());
  EXPECT_EQ(guided, verbs);
}

TEST(Guides, NameFlagsThatThereAreAndFewOfThem) {
  Program program;
  for (const auto* verb : program.verbs()) {
    const auto known = long_flags(*verb);
    const auto& common = guide_to(verb->get_name()).common;
    EXPECT_LE(common.size(), 10U) << verb->get_name();
    for (const auto flag : common)
      EXPECT_TRUE(holds(known, flag)) << verb->get_name() << " --" << flag;
  }
}

TEST(Guides, HaveTwoExamplesOfFlagsThatThereAre) {
  Program program;
  for (const auto* verb : program.verbs()) {
    const auto& examples = guide_to(verb->get_name()).examples;
    EXPECT_EQ(examples.size(), 2U) << verb->get_name();
    for (const auto example : examples) {
      const auto words = split(std::string(example));
      ASSERT_GT(words.size(), 2U);
      EXPECT_EQ(words[0], "coppermoon");
      EXPECT_EQ(words[1], verb->get_name());
      for (const auto& word : words)
        if (word.starts_with("-")) {
          EXPECT_NE(verb->get_option_no_throw(word), nullptr) << example;
        }
    }
  }
}

TEST(Help, OfAllListsEachFlagOnceInSentencesThatSayWhatItIs) {
  Program program;
  for (const auto* verb : program.verbs()) {
    const auto help = full_help(*verb);
    for (const auto& flag : flag_texts(*verb)) {
      EXPECT_SAYS(help, flag.names) << verb->get_name() << flag.names;
      EXPECT_GT(flag.text.size(), 10U) << flag.name;
      for (const char* bare : {"of ", "on or off", "as ", "by ", "its ", "that ", "without: "})
        EXPECT_FALSE(flag.text.starts_with(bare)) << flag.name << ": " << flag.text;
    }
  }
}

TEST(Help, LinesEndBeforeThePageDoes) {
  Program program;
  for (const auto* verb : program.verbs()) {
    std::istringstream lines(full_help(*verb));
    for (std::string line; std::getline(lines, line);)
      if (!line.starts_with("coppermoon") && !line.starts_with("  coppermoon")) {
        EXPECT_LE(std::ranges::count_if(line, [](char c) { return (c & 0xC0) != 0x80; }), 88)
            << line;
      }
  }
}

TEST(Suggestions, AreWhatIsMeantOrAlmostSpelt) {
  Program program;
  const auto flags = long_flags(*program.app.get_subcommand("still"));
  EXPECT_EQ(flag_suggested_for("fov", flags), "; did you mean --field?");
  EXPECT_EQ(flag_suggested_for("exposure", flags), "; did you mean --time?");
  EXPECT_EQ(flag_suggested_for("widht", flags), "; did you mean --width?");
  EXPECT_EQ(flag_suggested_for("verbose", flags), "");
  EXPECT_EQ(flag_suggested_for("xyz", flags), "");
  EXPECT_EQ(flag_suggested_for(std::string(100000, 'x'), flags), "");
  EXPECT_EQ(verb_suggested_for("render", {"still", "ring"}), "; did you mean still?");
  EXPECT_EQ(verb_suggested_for("stil", {"still", "ring"}), "; did you mean still?");
  EXPECT_EQ(verb_suggested_for("develope", {"still", "ring"}), "");
}

TEST(Suggestions, LeadFromNaturalWordsToFlagsAndCommands) {
  Program program;
  const auto flags_of = [&](const char* verb) {
    return long_flags(*program.app.get_subcommand(verb));
  };
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
  Program program;
  for (const auto& words :
       std::vector<std::vector<std::string>>{{"help"}, {"help", "still"}, {"still", "--help"}})
    EXPECT_THROW(run(program.app, words), CLI::CallForHelp);
  EXPECT_EQ(program.app.get_subcommands().front()->get_name(), "still");
  EXPECT_THROW(run(program.app, {"version"}), CLI::CallForVersion);
  EXPECT_THROW(run(program.app, {"help", "stil"}), WrongUsage);
}

TEST(PlainError, SaysTheValueAndWhatIsAllowed) {
  EXPECT_EQ(plain_error("--quality: best not in {draft,standard}"),
            "--quality = best, allowed draft, standard");
  EXPECT_EQ(plain_error("--threads: Value 9999 not in range 0 to 512"),
            "--threads = 9999, allowed 0 to 512");
  EXPECT_EQ(plain_error("--position-angle: Value 400 not in range 0.000000 to 360.000000"),
            "--position-angle = 400, allowed 0 to 360");
  EXPECT_EQ(plain_error("--width: Value a not in range 0.000000 to " + std::string(309, '1')),
            "--width = a, allowed a number, 0 or more");
  EXPECT_EQ(plain_error("--width: -5, allowed whole numbers, 0 or more"),
            "--width = -5, allowed whole numbers, 0 or more");
  EXPECT_EQ(plain_error("--output is required"), "--output: missing");
  EXPECT_EQ(plain_error("--instant is required"),
            "INSTANT: missing; a moment is needed, as 2026-03-03");
  EXPECT_EQ(plain_error("--at: 1 required TEXT missing"), "--at: a value is missing");
  EXPECT_EQ(plain_error("--plot excludes --lookup"), "--plot and --lookup: allowed one of the two");
  EXPECT_EQ(plain_error("The following argument was not expected: x"), "x: unexpected argument");
  EXPECT_EQ(plain_error("The following arguments were not expected: y x"),
            "x y: unexpected arguments");
  EXPECT_EQ(plain_error("Could not convert: --iso = a"), "--iso = a, allowed a number");
  EXPECT_EQ(plain_error("anything else"), "anything else");
}

}  // namespace
}  // namespace coppermoon::verbs
