// SPDX-License-Identifier: MIT
// Knobs and air at random: the error that is reported bounds the true one, held against light that no
// look-up was read for.
#include "end_to_end/planned_run.h"
#include "support/testing.h"

namespace coppermoon::uses::reached_test {

using namespace end_to_end;

/// Cloud of any height, and each knob as the plan has it or anything.
Run run_by_hand(std::uint64_t index) {
  auto run = random_run(index);
  Random random(1610, index);
  const auto sometimes = [&](const std::function<void()>& change) {
    if (random.uniform() < 0.4) change();
  };
  auto& column = run.request.air.column;
  if (!column.danjon)
    sometimes([&] {
      column.cloud_cover = between(random, 0.3, 1);
      column.cloud_top_km = between(random, 0, 30);
    });
  auto& hand = run.request.by_hand;
  sometimes([&] { hand.bands = static_cast<int>(log_between(random, 1, 200)); });
  sometimes([&] { hand.rays = static_cast<int>(log_between(random, 2, 1000)); });
  sometimes([&] { hand.sun_terms = static_cast<int>(between(random, 1, 6)); });
  sometimes([&] { hand.planes = static_cast<int>(between(random, 1, 5)); });
  sometimes([&] { hand.place_error = log_between(random, 1e-4, 1); });
  sometimes([&] { hand.terms = plan::Work{.ellipsoid = false, .scattered_light = true}; });
  return run;
}

void make_photons(Run& run, std::uint64_t index) {
  Random random(1616, index);
  run.request.photons = log_between(random, 1e4, 1e6);
  run.request.ring_km = log_between(random, 20, 500);
  run.request.smoothing_km = between(random, 0, 500);
}

/// Returned  how many times the error that is reported, and what nobody can ask for, the true one is
double times_reported(const Run& run, const Truth& truth, std::uint64_t index) {
  const auto result = result_of(run, 3, 10, truth, index);
  const auto& hand = run.request.by_hand;
  const double times = result.truth / (result.found + no_error);
  if (times > 1)
    fmt::print("{}: {:.2g} is reported, {:.2g} true; bands {}, rays {}, planes {}\n  {}\n", index,
               result.found, result.truth, hand.bands.value_or(0), hand.rays.value_or(0),
               hand.planes.value_or(0), described(run));
  return times;
}

/// At places that the report has not looked at, more may be wrong.
constexpr double between_places = 1.25;

TEST(Reached, BoundsTheErrorOfAnyKnobsInAirThatIsAlikeAllAround) {
  for (std::uint64_t i = 0; i < 8; ++i) {
    auto run = run_by_hand(i);
    run.request.air.column.danjon.reset();
    if (run.request.air.atmosphere == "standard") run.request.air.atmosphere = "undated";
    EXPECT_LT(times_reported(run, {.bands = 100, .rays = 1000}, i), between_places) << i;
  }
}

TEST(ReachedThoroughly, BoundsTheErrorOfAnyKnobsInAnyAir) {
  for (std::uint64_t i = 100; i < 140; ++i) {
    auto run = run_by_hand(i);
    if (i % 4 == 0) make_photons(run, i);
    EXPECT_LT(times_reported(run, {}, i), between_places) << i;
  }
}

}  // namespace coppermoon::uses::reached_test
