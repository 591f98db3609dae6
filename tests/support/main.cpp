// SPDX-License-Identifier: MIT
// Runs tests: PROGRAM [NOUN] [FLAGS of GoogleTest]. With a noun those of NOUN_test.cpp alone, of which there must be some.
// Tests with Thoroughly in the name of their suite run only with COPPERMOON_THOROUGH in the environment.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace {

/// GoogleTest's filter for the tests of one source file; empty when it has none.
std::string tests_of(const std::string& source) {
  std::string filter;
  const auto& all = *testing::UnitTest::GetInstance();
  for (int s = 0; s < all.total_test_suite_count(); ++s) {
    const auto& suite = *all.GetTestSuite(s);
    for (int t = 0; t < suite.total_test_count(); ++t) {
      const auto& test = *suite.GetTestInfo(t);
      if (std::filesystem::path(test.file()).filename() == source)
        filter += std::string(suite.name()) + '.' + test.name() + ':';
    }
  }
  return filter;
}

}  // namespace

int main(int count, char** words) {
  testing::InitGoogleTest(&count, words);
  if (count > 1) {
    const auto filter = tests_of(std::string(words[1]) + "_test.cpp");
    if (filter.empty()) {
      std::fprintf(stderr, "%s_test.cpp: no tests\n", words[1]);
      return 1;
    }
    testing::GTEST_FLAG(filter) = filter;
  }
  if (std::getenv("COPPERMOON_THOROUGH") == nullptr) {
    auto& filter = testing::GTEST_FLAG(filter);
    filter += (filter.find('-') == std::string::npos ? "-" : ":") + std::string("*Thoroughly*");
  }
  return RUN_ALL_TESTS();
}
