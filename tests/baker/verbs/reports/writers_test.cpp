// SPDX-License-Identifier: MIT
#include "verbs/reports/writers.h"

#include <gtest/gtest.h>

namespace coppermoon::verbs {
namespace {

TEST(Writers, AreChosenByTheEndingOfAFile) {
  std::string written;
  const auto into = [&](const char* name) {
    return [&written, name](const int& number, const std::filesystem::path& file) {
      written += fmt::format("{} {} {}. ", name, number, file.string());
    };
  };
  const Writers<int> writers{{{".csv"}, "a table", into("table")},
                             {{".png", ".svg"}, "a map", into("map")}};
  EXPECT_EQ(kinds_of(writers), ".csv for a table; .png, .svg for a map");
  write_files(7, {"a.svg", "b.csv", "c.png"}, writers);
  EXPECT_EQ(written, "map 7 a.svg. table 7 b.csv. map 7 c.png. ");
  const std::vector<std::string> names{"a.svg", "b.gif"};
  try {
    require_writers(names, writers);
    ADD_FAILURE() << "b.gif was taken";
  } catch (const algebra::Error& error) {
    EXPECT_STREQ(error.what(), "b.gif: allowed .csv for a table; .png, .svg for a map");
  }
  EXPECT_TRUE(has_ending(names, ".gif"));
  EXPECT_FALSE(has_ending(names, ".ics"));
}

}  // namespace
}  // namespace coppermoon::verbs
