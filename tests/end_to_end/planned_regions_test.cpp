// SPDX-License-Identifier: MIT
// The same as of planned_runs_test.cpp, where a region of the air is dusty. tests/thorough.sh draws every second one.
#include "end_to_end/planned_run.h"
#include "support/testing.h"

namespace coppermoon::end_to_end::planned_regions_test {

TEST(PlannedRegions, KeepTheirPromises) {
  constexpr std::uint64_t all = 20;
  std::vector<Result> results;
  for (std::uint64_t i = 0; i < all; ++i)
    if (support::is_drawn(i, 2))
      results.push_back(
          result_of(random_run_with_a_region(i), 4, 3, {.bands = 100, .rays = 1000}, i));
  print("random eclipses with a dusty region", results);
  const auto runs = static_cast<int>(results.size());
  EXPECT_GE(count(results, &Result::bounded), support::asked({18, 20}, 20, runs, 0.9).least)
      << "borders of regions are sharp";
  EXPECT_GE(count(results, &Result::told), support::asked({17, 20}, 20, runs, 0.85).least);
}

}  // namespace coppermoon::end_to_end::planned_regions_test
