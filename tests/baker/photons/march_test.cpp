// SPDX-License-Identifier: MIT
#include "photons/march.h"

#include <hwy/targets.h>

#include "atmosphere/presets.h"
#include "support/testing.h"

namespace coppermoon::photons {
namespace {

using atmosphere::Column;
using atmosphere::Density;

constexpr double radius_m = 6.378e6;
constexpr double green = 2.78e-4;  // n₀ − 1

std::vector<double> heights(double from_m, double to_m, int count) {
  std::vector<double> all;
  for (int i = 0; i < count; ++i) all.push_back(from_m + (to_m - from_m) * i / (count - 1));
  return all;
}

Column column_of(const char* preset) {
  return atmosphere::preset(preset, algebra::degrees(0)).column;
}

struct Followed {
  std::vector<LimbPath> paths;
  std::uint64_t steps;
};

Followed followed(const Column& column, const std::vector<double>& heights_m,
                  const Marching& marching, double refractivity = green) {
  Followed all{std::vector<LimbPath>(heights_m.size()), 0};
  all.steps = Marcher(column, radius_m, marching).follow(heights_m, refractivity, all.paths);
  return all;
}

/// The worst relative errors of bending and of each amount against another way.
struct Errors {
  double bending = 0;
  atmosphere::Amounts amounts{};
};

Errors worst(const std::vector<LimbPath>& paths, const std::vector<LimbPath>& reference) {
  Errors errors;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const auto &path = paths[i], &exact = reference[i];
    errors.bending = std::max(errors.bending, std::abs(path.bending_rad / exact.bending_rad - 1));
    for (std::size_t k = 0; k < exact.amounts.size(); ++k)
      if (exact.amounts[k] > 0)
        errors.amounts[k] =
            std::max(errors.amounts[k], std::abs(path.amounts[k] / exact.amounts[k] - 1));
  }
  return errors;
}

std::vector<LimbPath> exact(const Column& column, const std::vector<double>& heights_m,
                            double refractivity = green) {
  std::vector<LimbPath> paths;
  for (const double h : heights_m) paths.push_back(limb_path(h, radius_m, column, refractivity));
  return paths;
}

/// Optical depth of ozone and aerosol at 550 nm: limb_path's integral by 40 000 midpoints, which
/// kinks in the profiles do not disturb.
double by_midpoints(const Column& column, const atmosphere::Amounts& spectra, double h_t) {
  constexpr int points = 40'000;
  const double at_tangent = green * atmosphere::density_ratio(column, h_t).value * (radius_m + h_t);
  const double end = std::sqrt(85.999e3 - h_t), width = end / points;
  double sum = 0;
  for (int i = 0; i < points; ++i) {
    const double u = end * (i + 0.5) / points, h = h_t + u * u, r = radius_m + h;
    const double n_minus_1 = green * atmosphere::density_ratio(column, h).value;
    const double excess = u * u + n_minus_1 * r - at_tangent;  // n r − b
    const double nr_plus_b = 2 * (1 + n_minus_1) * r - excess;
    sum += atmosphere::product(atmosphere::profiles(column, h), spectra) * (1 + n_minus_1) * r /
           std::sqrt(excess * nr_plus_b) * 4 * u * width;
  }
  return sum;
}

struct Stated {
  Marching marching;
  double air, others;
};

class Marched : public testing::TestWithParam<Stated> {};

TEST_P(Marched, IsTheExactRayToWhatIsStated) {
  const auto& [marching, air, others] = GetParam();
  const auto at = heights(500, 40e3, 791);
  for (const char* preset : {"paper", "undated"}) {
    const Column column = column_of(preset);
    const auto errors = worst(followed(column, at, marching).paths, exact(column, at));
    EXPECT_WITHIN(errors.bending, 0., air, "as the header says") << preset;
    EXPECT_WITHIN(errors.amounts[atmosphere::air], 0., air, "as the header says") << preset;
  }
}

TEST_P(Marched, HasOzoneAndAerosolToWhatIsStated) {
  const auto& [marching, air, others] = GetParam();
  const Column column = column_of("undated");
  auto spectra = atmosphere::spectra(column, {green, 1.16e-5, 550});
  spectra[atmosphere::air] = 0;
  const auto at = heights(500, 40e3, 32);
  const auto paths = followed(column, at, marching).paths;
  for (std::size_t i = 0; i < at.size(); ++i)
    EXPECT_WITHIN_RELATIVE(atmosphere::product(paths[i].amounts, spectra),
                           by_midpoints(column, spectra, at[i]), others, "as the header says")
        << at[i];
}

INSTANTIATE_TEST_SUITE_P(Steps, Marched,
                         testing::Values(Stated{{1000}, 5e-7, 3e-6}, Stated{{10e3}, 6e-5, 6e-5},
                                         Stated{{30e3}, 5e-4, 1.5e-3},
                                         Stated{{1000, Precision::single}, 4e-6, 6e-6},
                                         Stated{{100, Precision::single}, 4e-5, 4e-5}),
                         [](const auto& stated) {
                           const auto& marching = stated.param.marching;
                           return std::to_string(static_cast<int>(marching.step_m)) + "m" +
                                  (marching.precision == Precision::single ? "Single" : "Full");
                         });

double root_mean_square(const std::vector<LimbPath>& paths,
                        const std::vector<LimbPath>& reference) {
  double sum = 0;
  for (std::size_t i = 0; i < paths.size(); ++i)
    sum += std::pow(paths[i].bending_rad / reference[i].bending_rad - 1, 2);
  return std::sqrt(sum / static_cast<double>(paths.size()));
}

TEST(Marcher, ConvergesFasterThanTheSquareOfTheStep) {
  const Column column{.density = Density::us_1976};
  const auto at = heights(22e3, 31e3, 91);
  const auto reference = exact(column, at);
  const auto of_step = [&](double step_m) {
    return root_mean_square(followed(column, at, {step_m}).paths, reference);
  };
  const double order = std::log2(of_step(32e3) / of_step(8e3)) / 2;
  EXPECT_WITHIN(order, 3., 0.5, "third order at the breaks above, fourth in smooth air");
}

TEST(Marcher, InSinglePrecisionIsThatInFull) {
  for (const char* preset : {"paper", "undated"})
    for (const double step_m : {777.75, 1000., 30e3}) {
      const Column column = column_of(preset);
      const auto at = heights(0, 41e3, 500);
      const auto errors = worst(followed(column, at, {step_m, Precision::single}).paths,
                                followed(column, at, {step_m}).paths);
      EXPECT_WITHIN(errors.bending, 0., 1e-5, "7 digits, and what sums of them lose") << step_m;
      for (const double error : errors.amounts)
        EXPECT_WITHIN(error, 0., 1e-5, "as above") << step_m;
    }
}

TEST(Marcher, InSinglePrecisionKeepsStepAndPlaceTogether) {
  const auto at = heights(500, 40e3, 100);
  const auto reference = exact({}, at);
  for (const double step_m : {333.3, 777.77, 1234.56})
    EXPECT_WITHIN(worst(followed({}, at, {step_m, Precision::single}).paths, reference).bending, 0.,
                  1e-5, "7 digits; steps that are no floats at 700 km would be off by 1e-4")
        << step_m;
}

/// Within a sphere about the Earth's centre, of a straight line.
double chord_m(double tangent_height_m, double altitude_m) {
  if (tangent_height_m >= altitude_m) return 0;
  return 2 * std::sqrt((altitude_m - tangent_height_m) *
                       (2 * radius_m + altitude_m + tangent_height_m));
}

TEST(Marcher, GoesStraightThroughAirThatDoesNotRefract) {
  const Column layer{.refraction = false, .dust_extinction_per_m = 1e-6};
  const auto at = heights(0, 41.9e3, 300);
  for (const auto& path : followed(layer, at, {}).paths) {
    EXPECT_EQ(path.bending_rad, 0);
    EXPECT_EQ(path.impact_height_m, path.tangent_height_m);
    const double h = path.tangent_height_m, length_m = chord_m(h, 20e3) - chord_m(h, 15e3);
    EXPECT_WITHIN(path.amounts[atmosphere::dust_layer], length_m, 1.,
                  "second differences of q along a straight line are constant, and the place "
                  "of a border known to rounding")
        << h;
  }
}

TEST(Marcher, HasTheImpactHeightOfTheExactRay) {
  const auto at = heights(0, 41.9e3, 50);
  const auto reference = exact({}, at);
  const auto paths = followed({}, at, {30e3}).paths;
  for (std::size_t i = 0; i < at.size(); ++i) {
    EXPECT_EQ(paths[i].tangent_height_m, at[i]);
    EXPECT_EQ(paths[i].impact_height_m, reference[i].impact_height_m);
  }
}

TEST(Marcher, LeavesRaysAloneWithoutAir) {
  const std::vector<double> ground{0, 0, 0};
  const auto all = followed({.density = Density::none}, ground, {});
  EXPECT_EQ(all.steps, 0);
  for (const auto& path : all.paths) {
    EXPECT_EQ(path.bending_rad, 0);
    EXPECT_EQ(path.amounts, atmosphere::Amounts{});
  }
  const auto vacuum = followed({}, {0, 10e3}, {}, 0).paths;
  EXPECT_EQ(vacuum[0].bending_rad, 0);
  EXPECT_EQ(vacuum[1].bending_rad, 0);
}

TEST(Marcher, CountsTheStepsItsRaysTake) {
  const Column dust_all_through{
      .dust_extinction_per_m = 1e-6, .dust_bottom_m = 0, .dust_top_m = 42e3};
  for (const auto precision : {Precision::full, Precision::single})
    for (const double h : {500., 20e3, 41e3, 41.99e3}) {
      const double steps =
          static_cast<double>(followed(dust_all_through, {h}, {1000, precision}).steps);
      const double length_m =
          limb_path(h, radius_m, dust_all_through, green).amounts[atmosphere::dust_layer];
      EXPECT_WITHIN(steps, length_m / 1000, 1.2, "a whole number; steps are of σ, not s") << h;
    }
}

TEST(Marcher, FollowsEachRayAsIfItWereAlone) {
  const Column column = column_of("undated");
  const std::vector<double> at{70e3, 500, 86e3, 12e3, 0, 40e3, 85.9e3, 11e3, 30e3, 1,
                               2,    3,   4,    5,    6, 7,    8,      9,    10,   11e3};
  for (const auto precision : {Precision::full, Precision::single}) {
    const auto together = followed(column, at, {1000, precision}).paths;
    for (std::size_t i = 0; i < at.size(); ++i) {
      const auto alone = followed(column, {at[i]}, {1000, precision}).paths[0];
      EXPECT_EQ(together[i].bending_rad, alone.bending_rad) << at[i];
      EXPECT_EQ(together[i].amounts, alone.amounts) << at[i];
    }
  }
}

TEST(Marcher, LeavesTheAirWhereverItGrazesAndHoweverLongTheStep) {
  for (const char* preset : {"paper", "undated"})
    for (const double step_m : {1e3, 30e3, 100e3}) {
      const Column column = column_of(preset);
      const double top_m = atmosphere::top_m(column);
      for (const auto& path : followed(column, heights(0, top_m, 997), {step_m}).paths) {
        EXPECT_TRUE(path.bending_rad >= -1e-9 && path.bending_rad < 0.03) << path.bending_rad;
        EXPECT_GE(path.amounts[atmosphere::air], -1.) << path.tangent_height_m;
      }
    }
}

TEST(Marcher, LeavesAirThatBendsAlmostAsTheEarthDoes) {
  for (const double step_m : {1e3, 10e3, 100e3})
    for (const auto precision : {Precision::full, Precision::single})
      for (const auto& path : followed({}, heights(0, 42e3, 99), {step_m, precision}, 1e-3).paths)
        EXPECT_TRUE(std::isfinite(path.bending_rad)) << path.tangent_height_m;
}

/// Runs with one SIMD target only, and gives the choice back.
class OnlyTarget {
 public:
  explicit OnlyTarget(std::int64_t target) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
  OnlyTarget(const OnlyTarget&) = delete;
  OnlyTarget& operator=(const OnlyTarget&) = delete;
  ~OnlyTarget() {
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
};

TEST(Marcher, IsTheSameOnEverySimdTarget) {
  const Column column = column_of("undated");
  const auto at = heights(0, 86e3, 37);
  const auto full = followed(column, at, {});
  const auto single = followed(column, at, {1000, Precision::single});
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    const OnlyTarget only(target);
    SCOPED_TRACE(hwy::TargetName(target));
    const auto other = followed(column, at, {});
    EXPECT_EQ(other.steps, full.steps);
    EXPECT_WITHIN(worst(other.paths, full.paths).bending, 0., 1e-9,
                  "rounding, where products are not fused with sums");
    const auto other_single = followed(column, at, {1000, Precision::single}).paths;
    const auto low = static_cast<std::ptrdiff_t>(at.size() / 2);
    EXPECT_WITHIN(worst({other_single.begin(), other_single.begin() + low},
                        {single.paths.begin(), single.paths.begin() + low})
                      .bending,
                  0., 1e-5, "rounding of floats");
  }
}

TEST(Marcher, RefusesWhatIsOutsideItsRange) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double step_m : {0., 0.99, 100'001., nan})
    EXPECT_THROW(Marcher({}, radius_m, {step_m}), algebra::Error) << step_m;
  for (const double earth_m : {0., 9e5, 1.1e7, nan})
    EXPECT_THROW(Marcher({}, earth_m, {}), algebra::Error) << earth_m;
  for (const double h : {-1., 42'001., nan})
    EXPECT_THROW(followed({}, {h}, {}), algebra::Error) << h;
  for (const double refractivity : {-1e-9, 1.1e-3, nan})
    EXPECT_THROW(followed({}, {1e3}, {}, refractivity), algebra::Error) << refractivity;
  std::vector<LimbPath> one(1);
  const std::vector<double> two{1e3, 2e3};
  EXPECT_THROW(Marcher({}, radius_m, {}).follow(two, green, one), algebra::Error);
}

}  // namespace
}  // namespace coppermoon::photons
