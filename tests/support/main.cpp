// SPDX-License-Identifier: MIT
// Runs tests: PROGRAM [NOUN] [FLAGS of GoogleTest]. With a noun those of NOUN_test.cpp alone, of which there must be some.
// Tests with Thoroughly in the name of their suite run only with COPPERMOON_THOROUGH in the environment. Appends a line
// `SECONDS PROGRAM/NOUN` of processor time, of the programs that the tests started too, to the file that
// COPPERMOON_PROCESSOR_SECONDS names.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
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

/// Processor seconds, user and system, of this process and of all children that it has waited for.
double processor_seconds() {
  double seconds = 0;
  for (const auto whose : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage used{};
    getrusage(whose, &used);
    for (const auto& time : {used.ru_utime, used.ru_stime})
      seconds += static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  }
  return seconds;
}

}  // namespace

int main(int count, char** words) {
  std::signal(
      SIGINT,
      SIG_DFL);  // ignored, also by what tests start, where a shell began them in the background
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
  const auto outcome = RUN_ALL_TESTS();
  if (const char* list = std::getenv("COPPERMOON_PROCESSOR_SECONDS")) {
    if (auto* file = std::fopen(list, "a")) {
      std::fprintf(file, "%.1f %s/%s\n", processor_seconds(),
                   std::filesystem::path(words[0]).filename().c_str(), count > 1 ? words[1] : "");
      std::fclose(file);
    }
  }
  return outcome;
}
