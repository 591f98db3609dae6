// SPDX-License-Identifier: MIT
#include "plan/laws.h"

#include "plan/plan.h"
#include "support/testing.h"

namespace coppermoon::plan::laws_test {

const std::vector<std::span<const LawPoint>> laws{law_of_bands, law_of_rays, law_of_sun_terms,
                                                  law_of_planes, law_of_place_error};

TEST(Law, OfAPowerIsThatPowerBetweenItsPointsAndBeyond) {
  const std::vector<LawPoint> inverse_square{{1, 1}, {10, 1e-2}, {1000, 1e-6}};
  for (const double x : {0.25, 1., 3., 10., 77., 1000., 4e4})
    EXPECT_WITHIN_RELATIVE(law(inverse_square, x), 1 / (x * x), 1e-12, "closed form; rounding");
}

TEST(Law, HitsItsPoints) {
  for (const auto points : laws)
    for (const auto& [setting, error] : points)
      EXPECT_WITHIN_RELATIVE(law(points, setting), error, 1e-12, "rounding");
}

TEST(Law, BendsAtAPoint) {
  const std::vector<LawPoint> bent{{1, 1}, {10, 0.1}, {100, 1e-4}};
  EXPECT_WITHIN_RELATIVE(law(bent, std::sqrt(10.)), std::sqrt(0.1), 1e-12, "rounding");
  EXPECT_WITHIN_RELATIVE(law(bent, std::sqrt(1000.)), std::sqrt(1e-5), 1e-12, "rounding");
}

TEST(Laws, FallTheFinerTheSetting) {
  for (const auto points : laws) {
    const bool finer_is_less = points.front().error < points.back().error;
    EXPECT_EQ(finer_is_less, points.data() == law_of_place_error.data());
    for (double x = points.front().setting; x < points.back().setting; x *= 1.07) {
      const double here = law(points, x), further = law(points, x * 1.07);
      EXPECT_TRUE(finer_is_less ? here < further : here > further) << x;
    }
  }
}

constexpr double endless = std::numeric_limits<double>::infinity();

Scene umbral() {
  return {.nearest_m = 0.5e6, .farthest_m = 4e6, .texels = 8e6, .without_ellipsoid = 0.05};
}

double sum_of_laws(const Work& work) {
  return law(law_of_bands, work.bands) + law(law_of_rays, work.rays) +
         law(law_of_sun_terms, work.sun_terms) + law(law_of_planes, work.planes) +
         law(law_of_place_error, work.place_error);
}

TEST(PredictedError, IsTheSumOfWhatTheKnobsLeave) {
  const Work work{
      .scattered_light = true, .bands = 40, .rays = 300, .sun_terms = 2, .place_error = 3e-3};
  EXPECT_WITHIN_RELATIVE(predicted_error(work, umbral()), sum_of_laws(work), 1e-12, "rounding");
}

TEST(PredictedError, CountsOnlyForTheLightThatIsRefracted) {
  auto scene = umbral();
  const Work work{.scattered_light = true};
  const double all = predicted_error(work, scene);
  scene.without_refracted = 0.01;
  EXPECT_WITHIN_RELATIVE(predicted_error(work, scene), 0.01 * all, 1e-12, "a hundredth of it");
}

TEST(PredictedError, HasEachTermThatIsLeftOutByItsSize) {
  const Scene scene{.columns = 3,
                    .parts = 6,
                    .borders = true,
                    .without_refracted = 0.7,
                    .without_ellipsoid = 0.05,
                    .without_regions = 0.3,
                    .without_scattered = 0.02};
  Work all;
  all.scattered_light = true;
  const double none_left_out = predicted_error(all, scene);
  const auto without = [&](bool Work::*term) {
    auto work = all;
    work.*term = false;
    return predicted_error(work, scene) - none_left_out;
  };
  EXPECT_WITHIN(without(&Work::ellipsoid), 0.05, 1e-12, "rounding");
  EXPECT_WITHIN(without(&Work::regions), 0.3, 1e-12, "rounding");
  EXPECT_WITHIN(without(&Work::scattered_light), 0.02, 1e-4, "what is in has an error of its own");
  EXPECT_WITHIN(without(&Work::refracted), 0.7 - none_left_out, 1e-4,
                "nothing is left for the knobs to spoil");
}

TEST(PredictedError, OfTermsThatTheSceneHasNotIsNone) {
  Work without;
  without.ellipsoid = without.regions = false;
  Scene sphere{.ellipsoid = false, .without_ellipsoid = 1, .without_regions = 1};
  EXPECT_EQ(predicted_error(without, sphere), predicted_error({}, sphere));
}

TEST(PredictedError, OfPhotonsFallsAsTheRootOfTheirNumber) {
  for (const auto solver : {Solver::table, Solver::literal}) {
    const auto noise = [&](double photons) {
      return predicted_error({.solver = solver, .photons = photons}, umbral()) -
             predicted_error({.solver = solver, .photons = endless}, umbral());
    };
    EXPECT_WITHIN_RELATIVE(noise(1e6) / noise(4e6), 2., 1e-9, "rounding");
  }
}

/// Works each a step finer than the last, by one knob alone.
std::vector<std::vector<Work>> finer_and_finer() {
  std::vector<std::vector<Work>> all(5);
  for (const int bands : {10, 11, 33, 64, 65, 200, 400}) all[0].push_back({.bands = bands});
  for (const int rays : {60, 61, 150, 700, 2000, 5000}) all[1].push_back({.rays = rays});
  for (const int terms : {1, 2, 3, 4, 5, 6}) all[2].push_back({.sun_terms = terms});
  for (const int planes : {1, 2, 3, 4, 5, 9}) all[3].push_back({.planes = planes});
  for (const double error : {0.3, 0.1, 0.02, 1e-3, 2e-4, 3e-5})
    all[4].push_back({.place_error = error});
  return all;
}

TEST(FinerKnobs, NeverPredictMoreErrorNorLessTime) {
  const auto scene = umbral();
  for (const auto& works : finer_and_finer())
    for (std::size_t i = 1; i < works.size(); ++i) {
      EXPECT_LT(predicted_error(works[i], scene), predicted_error(works[i - 1], scene)) << i;
      EXPECT_GE(predicted_seconds(works[i], scene, {}), predicted_seconds(works[i - 1], scene, {}))
          << i;
    }
}

TEST(PredictedSeconds, HalveOnAMachineTwiceAsFast) {
  EXPECT_WITHIN_RELATIVE(predicted_seconds({}, umbral(), {.speed = 2}),
                         predicted_seconds({}, umbral(), {}) / 2, 1e-12, "rounding");
}

/// Of parts that nothing else depends on, by one core.
TEST(PredictedSeconds, HaveAStartTexelsAndAMapAsMeasured) {
  const auto seconds = [](double texels, bool map_file) {
    auto scene = umbral();
    scene.texels = texels;
    scene.map_file = map_file;
    return predicted_seconds({}, scene, {.cores = 1});
  };
  EXPECT_WITHIN(seconds(1, false) - seconds(0, false), 0.22, 1e-6, "start: one texel is 48 ns");
  EXPECT_WITHIN(seconds(8e6, false) - seconds(1, false), 0.384, 1e-6, "48 ns each");
  EXPECT_WITHIN(seconds(0, true) - seconds(0, false), 0.2, 1e-6, "rounding");
}

TEST(PredictedSeconds, AreFewerWithMoreCoresButNotInProportion) {
  const double one = predicted_seconds({}, umbral(), {.cores = 1}),
               four = predicted_seconds({}, umbral(), {.cores = 4});
  EXPECT_LT(four, one);
  EXPECT_GE(four, one / 4);
}

TEST(PredictedSeconds, GrowWithTexelsTermsAndColumns) {
  const auto scene = umbral();
  auto more = scene;
  more.texels *= 4;
  EXPECT_GT(predicted_seconds({}, more, {}), predicted_seconds({}, scene, {}));
  more = scene;
  more.columns = 3, more.parts = 6, more.borders = true;
  EXPECT_GT(predicted_seconds({}, more, {}), predicted_seconds({}, scene, {}));
  EXPECT_GT(predicted_seconds({}, scene, {}), predicted_seconds({.ellipsoid = false}, scene, {}));
  EXPECT_GT(predicted_seconds({.ellipsoid = false}, scene, {}),
            predicted_seconds({.refracted = false}, scene, {}));
  EXPECT_GT(predicted_seconds({.scattered_light = true}, scene, {}),
            predicted_seconds({}, scene, {}));
}

TEST(PredictedSeconds, OfTermsThatTheSceneHasNotAreNone) {
  auto sphere = umbral();
  sphere.ellipsoid = false;
  for (const auto solver : {Solver::quadrature, Solver::table})
    EXPECT_EQ(
        predicted_seconds({.solver = solver, .photons = 1e6}, sphere, {}),
        predicted_seconds({.solver = solver, .photons = 1e6, .ellipsoid = false, .regions = false},
                          sphere, {}));
}

TEST(PredictedSeconds, GoFromTableToLiteralUpwards) {
  const auto seconds = [](Solver solver) {
    return predicted_seconds({.solver = solver, .photons = 1e6, .bands = 40}, umbral(), {});
  };
  EXPECT_LT(seconds(Solver::table), seconds(Solver::literal));
}

}  // namespace coppermoon::plan::laws_test
