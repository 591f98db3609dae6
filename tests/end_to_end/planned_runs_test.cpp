// SPDX-License-Identifier: MIT
// Random eclipses under random air to a random tolerance: is what was predicted true? Prints what it
// found as a Markdown table; each bound that was broken with its scene. tests/thorough.sh draws every second run.
#include "end_to_end/planned_run.h"
#include "support/testing.h"

namespace coppermoon::end_to_end::planned_runs_test {

TEST(PlannedRuns, KeepTheirPromises) {
  constexpr std::uint64_t all = 100;
  std::vector<Result> results;
  for (std::uint64_t i = 0; i < all; ++i)
    if (support::is_drawn(i, 2)) results.push_back(result_of(random_run(i), 3, 20, {}, i));
  print("random eclipses under random air", results);
  const auto runs = static_cast<int>(results.size());
  EXPECT_GE(count(results, &Result::bounded), support::asked({95, 100}, 100, runs, 0.95).least);
  EXPECT_GE(count(results, &Result::told), support::asked({90, 100}, 100, runs, 0.9).least);
}

/// Minutes from a contact, where part of the Moon is beside all shadow, with a knob or the tolerance at an end of its range.
Run run_at_an_end(std::uint64_t index) {
  auto run = random_run(index);
  Random random(1633, index);
  const auto contacts = contacts_of(random_eclipse(random));
  const auto& contact =
      contacts[static_cast<std::size_t>(random.uniform() * static_cast<double>(contacts.size()))];
  const bool first = contact.first == "P1", last = contact.first == "P4";
  run.when = almanac::later(contact.second, 60 * (first  ? between(random, 2, 10)
                                                  : last ? between(random, -10, -2)
                                                         : between(random, -10, 10)));
  auto& hand = run.request.by_hand;
  const std::array<std::function<void()>, 6> ends{[&] { hand.bands = 1; },
                                                  [&] { hand.place_error = 1; },
                                                  [&] { hand.planes = 1; },
                                                  [&] { hand.sun_terms = 1; },
                                                  [&] { run.request.wish.tolerance = 0.05; },
                                                  [&] { run.request.wish.tolerance = 0.5; }};
  ends[index % ends.size()]();
  return run;
}

TEST(PlannedRuns, SayNoLessThanTheirErrorAtTheEndsOfRanges) {
  constexpr std::uint64_t all = 60;
  int runs = 0, bounded = 0;
  for (std::uint64_t i = 0; i < all; ++i) {
    if (!support::is_drawn(i / 6, 2)) continue;  // each end as often
    ++runs;
    const auto run = run_at_an_end(i);
    const auto result = result_of(run, 3, 20, {}, i);
    if (result.truth <= result.found + no_error)
      ++bounded;
    else
      fmt::print("run {}: {:.2g} is said, {:.2g} true, knob {}\n  {}\n", i, result.found,
                 result.truth, i % 6, described(run));
  }
  EXPECT_GE(bounded, support::asked({57, 60}, 60, runs, 0.95).least);
}

TEST(TrueLuminance, IsThatOfThreeTimesTheRays) {
  for (std::uint64_t i = 0; i < 3; ++i) {
    const auto run = random_run(i);
    const auto moon = shadowed_moon(run.request, almanac::sky_at(run.when));
    const auto circle = circles_on(moon, 1, 5, i)[0];
    const auto usual =
        TrueLuminance(moon, {}).at(circle.depth_m, circle.distances_m, circle.angles_rad);
    const auto fine = TrueLuminance(moon, {.bands = 300, .rays = 6000})
                          .at(circle.depth_m, circle.distances_m, circle.angles_rad);
    for (std::size_t k = 0; k < usual.size(); ++k)
      EXPECT_WITHIN_RELATIVE(usual[k], fine[k], 3e-5, "a third of the finest tolerance");
  }
}

}  // namespace coppermoon::end_to_end::planned_runs_test
