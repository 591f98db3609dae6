// SPDX-License-Identifier: MIT
#include "algebra/table.h"

#include "support/testing.h"

namespace coppermoon::algebra::table_test {

std::string refusal(std::string_view text) {
  return refusal_of([&] { parse_table(text, "air.csv"); });
}

TEST(ParseTable, ReadsColumnsByName) {
  const auto table = parse_table("# source: none\nh_m,T_K\n0,288.15\n11e3,-2.5e-1\n", "air.csv");
  EXPECT_EQ(table["h_m"], (std::vector<double>{0, 11000}));
  EXPECT_EQ(table["T_K"], (std::vector<double>{288.15, -0.25}));
}

TEST(ParseTable, SkipsCommentsAndEmptyLinesAnywhere) {
  const auto table = parse_table("\n# a\nx\n1\n# b\n\n2", "air.csv");
  EXPECT_EQ(table["x"], (std::vector<double>{1, 2}));
}

TEST(ParseTable, TakesLineEndsOfBothKinds) {
  EXPECT_EQ(parse_table("x,y\r\n1,2\r\n", "air.csv")["y"], std::vector<double>{2});
  EXPECT_EQ(parse_table("\xEF\xBB\xBFx,y\r\n1,2", "air.csv")["x"], std::vector<double>{1});
}

TEST(ParseTable, RefusesUtf16InOneLine) {
  using namespace std::string_view_literals;
  for (const auto text : {"\xFF\xFEx\0\n\0"sv, "\xFE\xFF\0x"sv, "x\0\n\0"sv, "\0x"sv})
    EXPECT_EQ(refusal(text), "air.csv: text in UTF-16, allowed UTF-8");
}

TEST(ParseTable, NamesFileAndLineOfACellThatIsNoNumber) {
  EXPECT_EQ(refusal("# c\nx,y\n1,2\n3,four\n"), "air.csv:4: \"four\" is no number");
  EXPECT_EQ(refusal("x,y\n1,\n"), "air.csv:2: \"\" is no number");
  EXPECT_EQ(refusal("x\n1.5km\n"), "air.csv:2: \"1.5km\" is no number");
}

TEST(ParseTable, RefusesANumberTooLargeToKeep) {
  EXPECT_EQ(refusal("x\n1e999\n"), "air.csv:2: \"1e999\" is no number");
}

TEST(ParseTable, NamesFileAndLineOfALineOfTheWrongLength) {
  EXPECT_EQ(refusal("x,y\n1,2\n3\n"), "air.csv:3: 1 cells, expected 2");
  EXPECT_EQ(refusal("x,y\n1,2,3\n"), "air.csv:2: 3 cells, expected 2");
}

TEST(ParseTable, RefusesAnEmptyText) {
  EXPECT_EQ(refusal(""), "air.csv: empty table");
  EXPECT_EQ(refusal("# only a comment\n"), "air.csv: empty table");
}

TEST(Table, NamesAColumnItDoesNotHave) {
  const auto table = parse_table("x\n1\n", "air.csv");
  EXPECT_EQ(refusal_of([&] { table["z"]; }), "table has no column z");
}

TEST(ParseTextTable, KeepsCellsAsTextHeaderFirst) {
  const auto rows = parse_text_table("# c\nname,kind\nTycho,ray crater\n,\n");
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0], (std::vector<std::string>{"name", "kind"}));
  EXPECT_EQ(rows[1], (std::vector<std::string>{"Tycho", "ray crater"}));
  EXPECT_EQ(rows[2], (std::vector<std::string>{"", ""}));
}

}  // namespace coppermoon::algebra::table_test
