// SPDX-License-Identifier: MIT
#include "plan/plan.h"

#include "plan/laws.h"
#include "support/testing.h"

namespace coppermoon::plan::plan_test {

/// An eclipse like most: the disc in the umbra, an ellipsoid that matters, little scattered light.
Scene ordinary() {
  return {.nearest_m = 0.5e6,
          .farthest_m = 4e6,
          .texels = 8e6,
          .without_ellipsoid = 0.05,
          .without_scattered = 1e-5};
}

/// A disc that hardly any light of the air reaches.
Scene penumbral() {
  return {
      .nearest_m = 5e6, .farthest_m = 8.5e6, .without_refracted = 1e-4, .without_ellipsoid = 1e-5};
}

Plan within(double tolerance, const Scene& scene, const ByHand& by_hand = {}) {
  return plan_for(scene, {.tolerance = tolerance}, {}, by_hand);
}

bool names(const std::vector<LeftOut>& left_out, Term term) {
  return std::ranges::find(left_out, term, &LeftOut::term) != left_out.end();
}

const std::vector<double> tolerances{0.5, 0.2, 0.1, 0.03, 0.01, 3e-3, 1e-3, 3e-4, 1.5e-4};

TEST(PlanFor, MeetsItsTolerance) {
  for (const auto& scene : {ordinary(), penumbral()})
    for (const double tolerance : tolerances) {
      const auto plan = within(tolerance, scene);
      EXPECT_LE(plan.error, tolerance);
      EXPECT_EQ(plan.tolerance, tolerance);
      EXPECT_EQ(plan.error, predicted_error(plan.work, scene));
      EXPECT_EQ(plan.seconds, predicted_seconds(plan.work, scene, {}));
    }
}

TEST(PlanFor, NeitherErrsMoreNorWorksLessTheFinerTheTolerance) {
  for (const auto& scene : {ordinary(), penumbral()})
    for (std::size_t i = 1; i < tolerances.size(); ++i) {
      const auto coarse = within(tolerances[i - 1], scene), fine = within(tolerances[i], scene);
      EXPECT_LE(fine.error, coarse.error) << tolerances[i];
      EXPECT_GE(fine.seconds, coarse.seconds) << tolerances[i];
      EXPECT_GE(fine.work.bands, coarse.work.bands) << tolerances[i];
      EXPECT_GE(fine.work.rays, coarse.work.rays) << tolerances[i];
      EXPECT_LE(fine.work.place_error, coarse.work.place_error) << tolerances[i];
    }
}

TEST(PlanFor, LeavesWhatIsSetByHand) {
  const ByHand hand{.bands = 33, .rays = 123, .sun_terms = 5, .planes = 7, .place_error = 0.0123};
  for (const double tolerance : tolerances) {
    const auto work = within(tolerance, ordinary(), hand).work;
    EXPECT_EQ(work.bands, 33);
    EXPECT_EQ(work.planes, 7);
    if (work.solver != Solver::quadrature) continue;
    EXPECT_EQ(work.rays, 123);
    EXPECT_EQ(work.sun_terms, 5);
    EXPECT_EQ(work.place_error, 0.0123);
  }
}

TEST(PlanFor, LeavesTheTermsThatAreSetByHand) {
  auto scene = ordinary();
  scene.columns = 3, scene.parts = 6, scene.borders = true, scene.without_regions = 0.4,
  scene.without_scattered = 0.3;
  Work out;
  out.ellipsoid = out.regions = false;
  const auto plan = within(1e-3, scene, {.terms = out});
  EXPECT_TRUE(plan.work.refracted);
  EXPECT_FALSE(plan.work.ellipsoid || plan.work.regions || plan.work.scattered_light);
  ASSERT_EQ(plan.left_out.size(), 3U);
  EXPECT_EQ(plan.left_out[0].term, Term::regions) << "the largest first";
  EXPECT_EQ(plan.left_out[1].term, Term::scattered_light);
  EXPECT_EQ(plan.left_out[2].term, Term::ellipsoid);
  EXPECT_GE(plan.error, 0.05 + 0.4 + 0.3) << "says what that costs";
}

/// The sizes of three terms, one after the other.
TEST(PlanFor, LeavesOutWhatIsFarUnderTheToleranceAndNamesItsSize) {
  struct {
    double Scene::*size;
    bool Work::*in;
    Term term;
  } const terms[]{{&Scene::without_ellipsoid, &Work::ellipsoid, Term::ellipsoid},
                  {&Scene::without_regions, &Work::regions, Term::regions},
                  {&Scene::without_scattered, &Work::scattered_light, Term::scattered_light}};
  for (const auto& [size, in, term] : terms) {
    auto scene = ordinary();
    scene.columns = 3, scene.parts = 6, scene.borders = true, scene.without_regions = 0.4;
    scene.*size = 1e-5;
    const auto without = within(0.01, scene);
    EXPECT_FALSE(without.work.*in) << name(term);
    const auto said = std::ranges::find(without.left_out, term, &LeftOut::term);
    ASSERT_NE(said, without.left_out.end()) << name(term);
    EXPECT_EQ(said->size, 1e-5);
    scene.*size = 0.011;
    const auto with = within(0.01, scene);
    EXPECT_TRUE(with.work.*in) << name(term);
    EXPECT_FALSE(names(with.left_out, term)) << name(term);
  }
}

TEST(Term, HasANameOfItsOwn) {
  for (const auto term : {Term::refracted, Term::ellipsoid, Term::regions, Term::scattered_light})
    EXPECT_EQ(term_named(name(term)), term);
  EXPECT_THROW(term_named("twilight"), algebra::Error);
}

TEST(PlanFor, SendsNoLightThroughTheAirWhereNoneIsSeen) {
  const auto plan = within(0.01, penumbral());
  EXPECT_FALSE(plan.work.refracted);
  ASSERT_TRUE(names(plan.left_out, Term::refracted));
  EXPECT_EQ(plan.left_out.front().size, 1e-4);
  EXPECT_TRUE(within(0.01, ordinary()).work.refracted);
  EXPECT_LT(plan.seconds, within(0.01, ordinary()).seconds / 2) << "of both 0.1 s are the start";
}

TEST(PlanFor, SendsLightThroughTheAirHoweverMuchItsRegionsMatter) {
  // Without them it is more wrong than no light at all.
  auto scene = ordinary();
  scene.columns = 3, scene.parts = 6, scene.borders = true, scene.without_regions = 5;
  const auto plan = within(0.01, scene);
  EXPECT_TRUE(plan.work.refracted && plan.work.regions);
  EXPECT_LE(plan.error, 0.01);
}

TEST(PlanFor, HasNoTermsOfASunThatIsUniform) {
  auto scene = ordinary();
  scene.limb_darkening = false;
  EXPECT_EQ(within(1e-3, scene).work.sun_terms, 1);
}

TEST(PlanFor, PrefersTheQuadratureOverPhotons) {
  for (const double tolerance : {0.05, 0.01, 5e-4}) {
    const auto plan = within(tolerance, ordinary());
    EXPECT_EQ(plan.work.solver, Solver::quadrature);
    ASSERT_EQ(plan.methods.size(), 3U);
    EXPECT_TRUE(std::ranges::is_sorted(plan.methods, {}, &Alternative::seconds));
    EXPECT_EQ(plan.methods.front().solver, plan.work.solver);
    EXPECT_EQ(plan.methods.front().seconds, plan.seconds);
  }
}

TEST(PlanFor, TakesTheSolverAskedForAndNoOther) {
  for (const auto solver : {Solver::table, Solver::literal}) {
    const auto plan = within(0.02, ordinary(), {.solver = solver});
    EXPECT_EQ(plan.work.solver, solver);
    ASSERT_EQ(plan.methods.size(), 1U);
    EXPECT_LE(plan.error, 0.02);
    EXPECT_GT(plan.work.photons, 0);
  }
}

TEST(PlanFor, TakesAsManyPhotonsAsAskedFor) {
  const auto plan =
      within(1e-3, ordinary(), {.solver = Solver::literal, .photons = 1e7, .bands = 200});
  EXPECT_EQ(plan.work.photons, 1e7);
  EXPECT_GT(plan.error, 1e-3) << "which are too few, and it says so";
}

TEST(PlanFor, TakesFourTimesThePhotonsForHalfTheNoise) {
  const auto photons = [](double tolerance) {
    return within(tolerance, ordinary(), {.solver = Solver::table, .bands = 400, .planes = 9})
        .work.photons;
  };
  EXPECT_WITHIN(photons(0.01) / photons(0.02), 4, 2, "photons are doubled at a time");
}

TEST(PlanFor, WithABudgetIsTheFinestThatFits) {
  const auto scene = ordinary();
  for (const double tolerance : {0.03, 0.01, 1e-3}) {
    const auto known = within(tolerance, scene);
    const auto plan = plan_for(scene, {.budget_s = known.seconds}, {});
    EXPECT_LE(plan.seconds, known.seconds);
    EXPECT_LE(plan.error, 1.25 * tolerance) << "tolerances are tried at steps of 1.25";
    EXPECT_FALSE(plan.misses_tolerance) << "no tolerance was asked for";
  }
}

TEST(PlanFor, WithMoreTimeErrsLess) {
  double last = 1;
  for (const double budget_s : {0.15, 0.25, 0.4, 0.8, 2., 20.}) {
    const auto plan = plan_for(ordinary(), {.budget_s = budget_s}, {});
    EXPECT_LE(plan.error, last) << budget_s;
    last = plan.error;
  }
}

TEST(PlanFor, LetsTheToleranceGiveWayToTheBudgetAndSaysSo) {
  const auto scene = ordinary();
  const auto fine = within(1e-3, scene);
  const double time = (fine.seconds + within(0.01, scene).seconds) / 2;
  const auto both = plan_for(scene, {.tolerance = 1e-3, .budget_s = time}, {});
  EXPECT_TRUE(both.misses_tolerance);
  EXPECT_FALSE(both.exceeds_budget);
  EXPECT_LE(both.seconds, time);
  EXPECT_GT(both.error, 1e-3);
  EXPECT_GE(both.tolerance, both.error) << "the tolerance that was met in its place";
}

/// Scattered light leaves more error than may be, whatever is done.
Scene beyond_reach() {
  auto scene = ordinary();
  scene.without_scattered = 0.5;
  return scene;
}

TEST(PlanFor, SaysSoWhereAToleranceIsNotToBeHad) {
  const auto plan = plan_for(beyond_reach(), {.tolerance = 1e-3}, {});
  EXPECT_GT(plan.error, 1e-3);
  EXPECT_TRUE(plan.misses_tolerance);
  EXPECT_FALSE(within(1e-3, ordinary()).misses_tolerance);
  EXPECT_FALSE(plan_for(beyond_reach(), {.budget_s = 1e3}, {}).misses_tolerance)
      << "nobody asked for one";
}

TEST(PlanFor, DoesNotSendPhotonsAfterAToleranceThatIsNotToBeHad) {
  for (const double tolerance : {1e-4, 5e-4, 1e-3})
    EXPECT_EQ(plan_for(beyond_reach(), {.tolerance = tolerance}, {}).work.solver,
              Solver::quadrature);
}

TEST(PlanFor, HasScatteredLightThatIsAskedForHoweverLittleItIs) {
  auto scene = ordinary();
  scene.without_scattered = 1e-7;
  EXPECT_FALSE(plan_for(scene, {.tolerance = 0.01}, {}).work.scattered_light);
  const auto plan = plan_for(scene, {.tolerance = 1e-3}, {}, {.scattered_light = true});
  EXPECT_TRUE(plan.work.scattered_light);
  EXPECT_LE(plan.error, 1e-3) << "of little light little error";
}

TEST(PlanFor, ChoosesTheSolverAsIfNothingWereSetByHand) {
  ByHand without_terms;
  without_terms.terms = Work{.ellipsoid = false};
  for (const ByHand& coarse :
       {ByHand{.rays = 20}, ByHand{.bands = 1}, ByHand{.place_error = 1}, without_terms}) {
    const auto plan = plan_for(ordinary(), {.tolerance = 0.01}, {}, coarse);
    EXPECT_EQ(plan.work.solver, Solver::quadrature) << "coarse as was asked, in no time";
    EXPECT_GT(plan.error, 0.01);
  }
}

TEST(PlanFor, StopsAtTheToleranceThoughThereIsTime) {
  const auto scene = ordinary();
  const auto plan = plan_for(scene, {.tolerance = 0.01, .budget_s = 100}, {});
  EXPECT_EQ(plan.seconds, within(0.01, scene).seconds);
  EXPECT_FALSE(plan.misses_tolerance);
}

TEST(PlanFor, WithTooLittleTimeForAnythingIsTheCoarsest) {
  const auto plan = plan_for(ordinary(), {.tolerance = 0.01, .budget_s = 1e-3}, {});
  EXPECT_TRUE(plan.exceeds_budget) << "even the coarsest light takes longer";
  EXPECT_TRUE(plan.misses_tolerance);
  EXPECT_GT(plan.seconds, 1e-3);
  EXPECT_LE(plan.seconds, within(0.4, ordinary()).seconds);
}

TEST(PlanFor, FitsABudgetOnASlowMachineWithCoarserWork) {
  auto scene = ordinary();
  scene.texels = 0;
  const double budget_s = within(1e-3, scene).seconds;
  const auto here = plan_for(scene, {.budget_s = budget_s}, {}),
             slow = plan_for(scene, {.budget_s = budget_s}, {.speed = 0.5});
  EXPECT_LE(slow.seconds, budget_s);
  EXPECT_GT(slow.error, here.error);
}

TEST(PlanFor, RefusesWishesOutsideTheirRanges) {
  for (const double tolerance : {9e-5, 0.51, -1., 0.})
    EXPECT_THROW(within(tolerance, ordinary()), algebra::Error) << tolerance;
  for (const double budget_s : {9e-4, 1.1e7, -1.})
    EXPECT_THROW(plan_for(ordinary(), {.budget_s = budget_s}, {}), algebra::Error) << budget_s;
  EXPECT_THROW(plan_for(ordinary(), {}, {}), algebra::Error) << "nothing asked for";
  const auto text = refusal_of([] { within(0.7, ordinary()); });
  for (const char* part : {"tolerance", "0.7", "0.5"}) EXPECT_SAYS(text, part);
}

TEST(Name, TellsTheSolversApart) {
  EXPECT_EQ(name(Solver::quadrature), "quadrature");
  EXPECT_EQ(name(Solver::table), "photons by table");
  EXPECT_EQ(name(Solver::literal), "photons literal");
}

TEST(WorkOfRays, GrowsWithWhatIsAskedFor) {
  const auto coarse = work_of_rays(1e-2, true), fine = work_of_rays(1e-4, true);
  EXPECT_LT(coarse.rays, fine.rays);
  EXPECT_LE(coarse.sun_terms, fine.sun_terms);
  EXPECT_EQ(work_of_rays(1e-3, true, {.rays = 77}).rays, 77);
  EXPECT_THROW(work_of_rays(1, true), algebra::Error);
}

TEST(Finer, IsFinerInEveryKnobAndNeverCoarse) {
  const Work coarse{.ellipsoid = false, .regions = false, .bands = 2, .rays = 2, .sun_terms = 1};
  const auto fine = finer(coarse);
  EXPECT_GE(fine.bands, 64) << "4e-4: law_of_bands";
  EXPECT_GE(fine.rays, 600) << "3e-4: law_of_rays";
  EXPECT_GE(fine.sun_terms, 3) << "3e-4: law_of_sun_terms";
  EXPECT_TRUE(fine.refracted && fine.ellipsoid && fine.regions);
  EXPECT_EQ(finer({.bands = 100, .rays = 500}).bands, 200);
  EXPECT_EQ(finer({.bands = 100, .rays = 500}).rays, 1000);
  EXPECT_EQ(finer({.solver = Solver::table, .photons = 2000, .rays = 1000}).rays, 600)
      << "the noise of photons is larger";
  EXPECT_EQ(finer({.sun_terms = 4}).sun_terms, 5);
  EXPECT_EQ(finer({.sun_terms = 6}).sun_terms, 6) << "all";
  EXPECT_LE(finer({.bands = 400, .rays = 10'000'000}).rays, 10'000'000) << "what is allowed";
}

}  // namespace coppermoon::plan::plan_test
