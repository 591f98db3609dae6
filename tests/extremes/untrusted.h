// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "extremes/tried.h"
#include "support/program.h"

namespace coppermoon::extremes {

constexpr const char* eclipse_of_2008 = "2008-02-21T03:26:05Z";

/// What it is given may come from anyone: it is used, or refused in one line, and nothing is left.
class Untrusted : public ProgramTest {
 protected:
  /// A row of the table for a refusal.
  void expect_refused(const std::string& what, const Outcome& outcome, const std::string& part,
                      int status = could_not) const {
    EXPECT_EQ(outcome.status, status) << what << ": " << outcome.err;
    EXPECT_TRUE(outcome.err.starts_with("coppermoon: ")) << what << ": " << outcome.err;
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << what << ": " << outcome.err;
    EXPECT_LT(outcome.err.size(), 3000U) << what;
    EXPECT_SAYS(outcome.err, part) << what << ": " << outcome.err;
    refused(what, outcome.err.substr(0, outcome.err.find('\n')));
  }

  /// A quick texture of a Moon without shadow.
  static Words bake(const Words& more) {
    return words_of("bake {} --unshadowed --texture-width 16", eclipse_of_2008) + more;
  }

  void oiiotool(const Words& words) const {
    const auto outcome = run(Words{"oiiotool"} + words);
    ASSERT_EQ(outcome.status, 0) << outcome.err << outcome.out;
  }
};

}  // namespace coppermoon::extremes
