// SPDX-License-Identifier: MIT
#include "verbs/reports/one_line.h"

#include "support/testing.h"

namespace coppermoon::verbs::one_line_test {

TEST(OneLine, LeavesTextAlone) {
  for (const char* text :
       {"", "moon.exr: cannot be read", "caf\xC3\xA9 \xE6\x9C\x88 \xF0\x9F\x8C\x91"})
    EXPECT_EQ(one_line(text), text);
}

TEST(OneLine, ShowsWhatATerminalWouldObey) {
  EXPECT_EQ(one_line("a\nb\n\n"), "a\\nb");
  EXPECT_EQ(one_line("a\r\t\x1b[31m\x7f"), "a\\x0d\\x09\\x1b[31m\\x7f");
  EXPECT_EQ(one_line("\xC2\x9B"), "\\xc2\\x9b") << "U+009B, as ESC [";
  EXPECT_EQ(one_line("caf\xE9"), "caf\\xe9");
}

TEST(OneLine, IsNeverLong) {
  const auto line = one_line("head" + std::string(1'000'000, '\x1b') + "allowed 1 to 2");
  EXPECT_LT(line.size(), 4U * 2000);
  EXPECT_TRUE(line.starts_with("head"));
  EXPECT_TRUE(line.ends_with("allowed 1 to 2"));
}

/// The sequences of RFC 3629, section 4, at their ends and just outside.
TEST(Utf8, IsToldFromOtherBytes) {
  for (const char* text : {"\x7F", "\xC2\x80", "\xDF\xBF", "\xE0\xA0\x80", "\xED\x9F\xBF",
                           "\xEE\x80\x80", "\xF0\x90\x80\x80", "\xF4\x8F\xBF\xBF"})
    EXPECT_TRUE(is_utf8(text)) << text;
  for (const char* text : {"\x80", "\xC1\xBF", "\xC2", "\xE0\x9F\xBF", "\xED\xA0\x80", "\xE6\x9C",
                           "\xF0\x8F\xBF\xBF", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF"})
    EXPECT_FALSE(is_utf8(text)) << text;
}

}  // namespace coppermoon::verbs::one_line_test
