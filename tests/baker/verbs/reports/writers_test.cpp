// SPDX-License-Identifier: MIT
#include "verbs/reports/writers.h"
#include "support/testing.h"

namespace coppermoon::verbs::writers_test {

TEST(Writers, AreChosenByTheEndingOfAFile) {
  std::string written;
  const auto into = [&](const char* name) {
    return [&written, name](const int& number, const std::filesystem::path& file) {
      written += fmt::format("{} {} {}. ", name, number, file.string());
    };
  };
  const Writers<int> writers{{{".csv", "table"}, into("table")},
                             {{".png", "map"}, into("map")},
                             {{".svg", "map"}, into("map")}};
  write_files(7, {"a.svg", "b.csv", "c.png"}, writers);
  EXPECT_EQ(written, "map 7 a.svg. table 7 b.csv. map 7 c.png. ");
  const std::vector<std::string> names{"a.svg", "b.gif"};
  EXPECT_EQ(refusal_of([&] { require_writers(names, writers, "a number"); }),
            "b.gif: a number ends in .csv (table), .png (map), .svg (map)");
  EXPECT_TRUE(has_ending(names, ".gif"));
  EXPECT_FALSE(has_ending(names, ".ics"));
}

}  // namespace coppermoon::verbs::writers_test
