// SPDX-License-Identifier: MIT
// What a user has set for POV-Ray and gnuplot changes no picture of ours.
#include "support/program.h"

namespace coppermoon::end_to_end::personal_settings_test {

class PersonalSettings : public ProgramTest {
 protected:
  /// With a home folder, and POVINI where it is given.
  Outcome at_home(const Words& words, const std::string& povini = {}) const {
    Words all{"env", "HOME=" + here("home").string()};
    if (!povini.empty()) all.push_back("POVINI=" + here(povini).string());
    all.push_back(COPPERMOON_PROGRAM);
    all += words;
    return run(all);
  }

  static Words still(const char* output) {
    return {"still",        "2008-02-21T03:26:05Z",
            "--unshadowed", "--texture-width",
            "64",           "--width",
            "48",           "--height",
            "36",           "--albedo-map",
            "built-in",     "-o",
            output};
  }
};

TEST_F(PersonalSettings, OfPovrayDoNotCount) {
  expect_done(coppermoon(still("alone.png")));
  const auto alone = text_of(here("alone.png"));
  const std::string settings = "Start_Row=20\nQuality=1\n";
  std::filesystem::create_directories(here("home/.povray/3.7"));
  file("home/.povray/3.7/povray.ini", settings);
  expect_done(at_home(still("home.png")));
  EXPECT_EQ(text_of(here("home.png")), alone);
  file("mine.ini", settings);
  expect_done(at_home(still("povini.png"), "mine.ini"));
  EXPECT_EQ(text_of(here("povini.png")), alone);
}

TEST_F(PersonalSettings, OfGnuplotDoNotCount) {
  const auto plot = [](const char* output) {
    return words_of(
        "shadow 2008-02-21T03:26:05Z --tolerance 20% --axis-distances 0,3000,6000 -o {}", output);
  };
  expect_done(coppermoon(plot("alone.png")));
  std::filesystem::create_directory(here("home"));
  file("home/.gnuplot", "exit status 3\n");
  expect_done(at_home(plot("home.png")));
  EXPECT_EQ(text_of(here("home.png")), text_of(here("alone.png")));
}

}  // namespace coppermoon::end_to_end::personal_settings_test
