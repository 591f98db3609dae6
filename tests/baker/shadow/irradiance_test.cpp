// SPDX-License-Identifier: MIT
#include "shadow/irradiance.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "photons/solar_disc.h"
#include "shadow/by_quadrature.h"
#include "support/testing.h"

namespace coppermoon::shadow::irradiance_test {

constexpr double pi = std::numbers::pi, sun_m = 1.479e11, moon_m = 3.83e8, earth_m = 6.42e6;

TEST(LensArea, IsTheSmallerCircleInsideTheLarger) {
  EXPECT_WITHIN_RELATIVE(lens_area(0.5, 1, 3), pi, 1e-15, "closed form");
  EXPECT_EQ(lens_area(4, 1, 3), 0);
}

TEST(LensArea, OfEqualCirclesThroughEachOthersCentres) {
  // The vesica piscis: 2π/3 − √3/2.
  EXPECT_WITHIN_RELATIVE(lens_area(1, 1, 1), 2 * pi / 3 - std::sqrt(3.) / 2, 1e-14, "closed form");
}

TEST(LensArea, RisesFromTouchToTouchWithoutAJump) {
  double before = lens_area(0.7, 1e-9, 1.7);
  for (int i = 1; i <= 3000; ++i) {
    const double here = lens_area(0.7, 1e-3 * i, 1.7);
    EXPECT_GE(here, before - 1e-12);
    EXPECT_LT(here - before, 1e-3 * 2 * pi * 1.7);  // no faster than a whole circumference
    before = here;
  }
}

/// The part of the Sun's disc in sight, point by point in space: a straight line to each, blocked
/// by a sphere.
double direct_point_by_point(double axis_distance_m, double sphere_m) {
  constexpr int n = 1500;
  const glm::dvec3 here(axis_distance_m, 0, moon_m);
  int seen = 0, all = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double x = (2 * (i + 0.5) / n - 1), y = (2 * (j + 0.5) / n - 1);
      if (x * x + y * y > 1) continue;
      ++all;
      const auto towards = glm::normalize(
          glm::dvec3(x * photons::solar_radius_m, y * photons::solar_radius_m, -sun_m) - here);
      const auto nearest = here - glm::dot(here, towards) * towards;
      if (glm::length(nearest) > sphere_m) ++seen;
    }
  return static_cast<double>(seen) / all;
}

double direct_ratio(double axis_distance_m) {
  double ratio = NAN;
  const std::vector<double> wave{550};
  DirectLight({}, {sun_m, {moon_m}}, wave).ratios(axis_distance_m, 0, moon_m, {&ratio, 1});
  return ratio;
}

TEST(DirectLight, IsThePartOfTheSunInSight) {
  for (const double km : {4700., 5500., 6420., 7500., 8150.})
    EXPECT_WITHIN(
        direct_ratio(km * 1e3), direct_point_by_point(km * 1e3, earth_m), 1e-4,
        "1.8 million points of the disc: 2e-5 of counting; the planes taken as parallel: 1e-5");
}

TEST(DirectLight, IsNothingInTheUmbraAndAllBeyondThePenumbra) {
  // Similar triangles, the limb's tangent circle taken at the Earth's centre.
  const double umbra = earth_m - moon_m / sun_m * (photons::solar_radius_m - earth_m);
  const double penumbra = earth_m + moon_m / sun_m * (photons::solar_radius_m + earth_m);
  EXPECT_EQ(direct_ratio(0), 0);
  EXPECT_EQ(direct_ratio(umbra - 2e3), 0);
  EXPECT_GT(direct_ratio(umbra + 20e3), 0);
  EXPECT_LT(direct_ratio(penumbra - 20e3), 1);
  EXPECT_EQ(direct_ratio(penumbra + 20e3), 1);
}

TEST(Landing, FollowsTheStraightLineWhenNothingBends) {
  // From (0, −D) to the limb's tangent, on to z: b / cos ε is where the ray passes the Earth's
  // centre.
  const double slope = std::asin(earth_m / sun_m);
  EXPECT_WITHIN_RELATIVE(landing_m(earth_m, 0, sun_m, moon_m), (sun_m + moon_m) * std::tan(slope),
                         1e-9, "closed form; the ray passes D tan ε = b / cos ε to 1e-9");
}

TEST(MeanRatio, IsThatOfAllPositionAnglesOfAPlane) {
  RefractedLight light{{sun_m, {3.8e8, 3.9e8}}, {500, 600}, {0, 1e6, 2e6}, 4, {}, {}};
  for (int plane = 0; plane < 2; ++plane)
    for (const double sector : {1., 2., 3., 6.})
      light.ratio.emplace_back(3, 2, sector + 10 * plane);
  light.ratio[1](2, 1) = 6;
  EXPECT_EQ(mean_ratio(light)(0, 0), 3);
  EXPECT_EQ(mean_ratio(light)(2, 1), 4);
  EXPECT_EQ(mean_ratio(light, 1)(0, 0), 13);
}

TEST(MeanRatio, OfAnEllipsoidIsNoOneSectors) {
  const atmosphere::Atmosphere air{.earth = atmosphere::ellipsoid(0)};
  const std::vector<double> waves{600}, places{3.5e6};
  const auto in = [&](std::size_t sectors) {
    return by_quadrature(air, {sun_m, {moon_m}}, waves, places, {.sectors = {sectors}});
  };
  const auto light = in(24);
  EXPECT_WITHIN_RELATIVE(mean_ratio(light)(0, 0), mean_ratio(in(90))(0, 0), 1e-12,
                         "cos 2θ and cos 4θ vanish in the mean over any even number of sectors");
  EXPECT_GT(std::abs(light.ratio[0](0, 0) / mean_ratio(light)(0, 0) - 1), 0.005)
      << "towards the pole the limb is lower";
}

TEST(Arrangement, OutsideItsRangeIsRefused) {
  EXPECT_THROW(require_valid(Arrangement{1e9, {3.8e8}}), algebra::Error);
  EXPECT_THROW(require_valid(Arrangement{1.5e11, {-3.8e8}}), algebra::Error);
  EXPECT_THROW(require_valid(Arrangement{1.5e11, {NAN}}), algebra::Error);
}

}  // namespace coppermoon::shadow::irradiance_test
