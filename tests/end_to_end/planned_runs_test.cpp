// SPDX-License-Identifier: MIT
// Random eclipses under random air to a random tolerance: is what was predicted true? Prints what it
// found as a Markdown table; each bound that was broken with its scene.
#include "end_to_end/planned_run.h"

namespace coppermoon::end_to_end {
namespace {

TEST(PlannedRuns, KeepTheirPromises) {
  constexpr std::uint64_t runs = 100;
  std::vector<Result> results;
  for (std::uint64_t i = 0; i < runs; ++i)
    results.push_back(result_of(random_run(i), 3, 20, {}, i));
  print("random eclipses under random air", results);
  EXPECT_GE(count(results, &Result::bounded), 95);
  EXPECT_GE(count(results, &Result::told), 90);
}

TEST(TrueLuminance, IsThatOfThreeTimesTheRays) {
  for (std::uint64_t i = 0; i < 3; ++i) {
    const auto run = random_run(i);
    const auto moon = moon_of(run, almanac::sky_at(run.when));
    const auto circle = circles_on(moon, 1, 5, i)[0];
    const auto usual =
        TrueLuminance(moon, {}).at(circle.depth_m, circle.distances_m, circle.angles_rad);
    const auto fine = TrueLuminance(moon, {.bands = 300, .rays = 6000})
                          .at(circle.depth_m, circle.distances_m, circle.angles_rad);
    for (std::size_t k = 0; k < usual.size(); ++k)
      EXPECT_WITHIN_RELATIVE(usual[k], fine[k], 3e-5, "a third of the finest tolerance");
  }
}

}  // namespace
}  // namespace coppermoon::end_to_end
