// SPDX-License-Identifier: MIT
// The same as of planned_runs_test.cpp, where a region of the air is dusty.
#include "end_to_end/planned_run.h"

namespace coppermoon::end_to_end {
namespace {

TEST(PlannedRegions, KeepTheirPromises) {
  constexpr std::uint64_t runs = 20;
  std::vector<Result> results;
  for (std::uint64_t i = 0; i < runs; ++i)
    results.push_back(
        result_of(random_run_with_a_region(i), 4, 3, {.bands = 100, .rays = 1000}, i));
  print("random eclipses with a dusty region", results);
  EXPECT_GE(count(results, &Result::bounded), 18);  // 90 %: borders of regions are sharp
  EXPECT_GE(count(results, &Result::told), 17);
}

}  // namespace
}  // namespace coppermoon::end_to_end
