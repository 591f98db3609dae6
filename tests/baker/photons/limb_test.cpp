// SPDX-License-Identifier: MIT
#include "photons/limb.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>

#include "atmosphere/presets.h"
#include "support/within.h"

namespace coppermoon::photons {
namespace {

using algebra::degrees;
using std::numbers::pi;

const std::vector<atmosphere::Optics> optics{
    atmosphere::sea_level_optics(algebra::nanometres(450)),
    atmosphere::sea_level_optics(algebra::nanometres(650))};

atmosphere::Atmosphere standard(bool sphere) {
  auto air = atmosphere::preset("standard", degrees(15));
  air.molecules = {};
  if (sphere) air.earth = {};
  return air;
}

/// Along the shadow axis, so high above the limb at a position angle.
Ray above_the_limb(const atmosphere::Atmosphere& air, double height_m, double angle) {
  const double b = atmosphere::limb_at(air.earth, angle).radius_m + height_m;
  return {{b * std::sin(angle), b * std::cos(angle), -1e9}, {0, 0, 1}};
}

TEST(WholeLimb, LetsARayPassAsItsExactPathDoes) {
  const auto air = standard(true);
  const WholeLimb limb(air, optics, 500);
  for (double height = 2.2e3; height < 80e3; height *= 1.07)
    for (std::size_t w = 0; w < optics.size(); ++w) {
      const auto exact = limb_ray(height, air.earth.equatorial_radius_m, air.column, optics[w]);
      const auto passed = limb.passed(above_the_limb(air, height, 1), w);
      ASSERT_TRUE(exact && passed) << height;
      const auto& direction = passed->leaving.direction;
      EXPECT_WITHIN(std::hypot(direction.x, direction.y), std::sin(exact->bending_rad),
                    2e-3 * exact->bending_rad + 5e-7, "as the header says")
          << height;
      EXPECT_WITHIN(std::log(passed->transmittance), std::log(exact->transmittance),
                    2e-3 * exact->optical_depth + 2e-3, "as the header says")
          << height;
      EXPECT_WITHIN(glm::length(direction), 1, 1e-14, "rounding");
      EXPECT_WITHIN_RELATIVE(glm::length(glm::cross(passed->leaving.position_m, direction)),
                             air.earth.equatorial_radius_m + height, 1e-12,
                             "Bouguer: the impact parameter is kept");
    }
}

TEST(WholeLimb, StopsWhatMeetsTheGroundAndLeavesWhatPassesAbove) {
  for (const bool sphere : {true, false}) {
    const auto air = standard(sphere);
    const WholeLimb limb(air, optics, 100);
    for (const double angle : {0., 0.7, pi / 2, 4.}) {
      EXPECT_FALSE(limb.passed(above_the_limb(air, 1e3, angle), 0)) << angle;
      EXPECT_TRUE(limb.passed(above_the_limb(air, 3e3, angle), 0)) << angle;
      EXPECT_TRUE(limb.passed(above_the_limb(air, 85.9e3, angle), 0)) << angle;
      EXPECT_FALSE(limb.passed(above_the_limb(air, 86.1e3, angle), 0)) << angle;
    }
  }
}

TEST(WholeLimb, OfAnEllipsoidIsTheRayThatFitsItsLimb) {
  const auto air = standard(false);
  const WholeLimb limb(air, optics, 500);
  for (const double angle : {0., 0.4, pi / 4, 1.2, pi / 2})
    for (const double height : {4e3, 12e3, 30e3}) {
      const auto there = atmosphere::limb_at(air.earth, angle);
      const auto exact = limb_ray(height, there.curvature_radius_m, air.column, optics[1]);
      const auto passed = limb.passed(above_the_limb(air, height, angle), 1);
      ASSERT_TRUE(exact && passed);
      const auto& direction = passed->leaving.direction;
      EXPECT_WITHIN_RELATIVE(std::hypot(direction.x, direction.y), std::sin(exact->bending_rad),
                             2.1e-3, "the table's 2e-3, and cos² for the curvature");
    }
}

std::vector<double> arc(const WholeLimb& limb, double middle, double half) {
  std::vector<double> lengths(limb.parts().size());
  limb.arc(middle, half, lengths);
  return lengths;
}

TEST(Arc, OfASphereIsItsLength) {
  const WholeLimb limb(standard(true), optics, 10);
  EXPECT_WITHIN(arc(limb, 5.9, 1)[0], 2, 1e-14, "closed form, across north");
  EXPECT_WITHIN(arc(limb, 0, pi)[0], 2 * pi, 1e-14, "closed form, all around");
}

TEST(Arc, OfAnEllipsoidIsPolarByTheCosineSquared) {
  const WholeLimb limb(standard(false), optics, 10);
  const auto all = arc(limb, 1.3, pi);
  EXPECT_WITHIN(all[0], pi, 1e-13, "half equator");
  EXPECT_WITHIN(all[1], pi, 1e-13, "half pole");
  EXPECT_WITHIN(arc(limb, 0, 1e-4)[1] / 2e-4, 1, 1e-7, "the pole");
  EXPECT_WITHIN(arc(limb, pi / 2, 1e-4)[0] / 2e-4, 1, 1e-7, "the equator");
}

TEST(Arc, IsCutAtTheBordersOfRegions) {
  auto air = standard(true);
  air.regions = {{degrees(350), degrees(20), {}}, {degrees(10), degrees(90), {}}};
  const WholeLimb limb(air, optics, 10);
  const double degree = pi / 180;
  const auto lengths = arc(limb, 0, 45 * degree);  // −45° to 45°
  EXPECT_WITHIN(lengths[0], 35 * degree, 1e-13, "−45° to −10°");
  EXPECT_WITHIN(lengths[1], 30 * degree, 1e-13, "−10° to 20°");
  EXPECT_WITHIN(lengths[2], 25 * degree, 1e-13,
                "20° to 45°: the first region that holds it counts");
  const auto across = arc(limb, 2 * pi + 0.001, 45 * degree);
  EXPECT_WITHIN(std::accumulate(across.begin(), across.end(), 0.), 90 * degree, 1e-13,
                "whole turns do not matter");
}

}  // namespace
}  // namespace coppermoon::photons
