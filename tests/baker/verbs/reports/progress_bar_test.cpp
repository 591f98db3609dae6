// SPDX-License-Identifier: MIT
#include "verbs/reports/progress_bar.h"

#include "support/testing.h"

namespace coppermoon::verbs::progress_bar_test {

using namespace std::chrono_literals;

TEST(AtWork, IsSaidAfterAWhileAndThenAgain) {
  testing::internal::CaptureStderr();
  {
    const AtWork quick("plan");
    const AtWork long_one("bake", 20ms, 30ms);
    std::this_thread::sleep_for(200ms);
  }
  const auto said = testing::internal::GetCapturedStderr();
  EXPECT_SAYS_NOT(said, "plan");
  EXPECT_EQ(said.find("coppermoon: bake: at work for 0 s\n"), 0U) << said;
  EXPECT_NE(said.rfind("bake"), said.find("bake")) << "again";
}

}  // namespace coppermoon::verbs::progress_bar_test
