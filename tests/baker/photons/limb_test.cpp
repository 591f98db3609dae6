// SPDX-License-Identifier: MIT
#include "photons/limb.h"

#include <gtest/gtest.h>

#include <numbers>

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

TEST(WholeLimb, OfASphereIsOnePartAllAround) {
  const WholeLimb limb(standard(true), optics, 10);
  ASSERT_EQ(limb.parts().size(), 1U);
  EXPECT_EQ(limb.at(2)[0].share, 1);
  EXPECT_EQ(limb.at(2)[1].share, 0);
  EXPECT_TRUE(limb.borders_rad().empty());
}

TEST(WholeLimb, OfAnEllipsoidIsPolarByTheCosineSquared) {
  const auto air = standard(false);
  const WholeLimb limb(air, optics, 10);
  ASSERT_EQ(limb.parts().size(), 2U);
  for (const double angle : {0., 0.4, pi / 4, 1.2, pi / 2, 4.}) {
    const auto shares = limb.at(angle);
    double radius = 0;
    for (const auto& [part, share] : shares) radius += share * limb.parts()[part].radius_m;
    EXPECT_WITHIN(radius, atmosphere::limb_at(air.earth, angle).radius_m, 0.003 * 21.4e3,
                  "0.3 % of the difference between pole and equator");
  }
}

TEST(WholeLimb, EndsItsColumnsAtTheBordersOfRegions) {
  auto air = standard(true);
  air.regions = {{degrees(350), degrees(20), {}}, {degrees(10), degrees(90), {}}};
  const WholeLimb limb(air, optics, 10);
  const double degree = pi / 180;
  ASSERT_EQ(limb.borders_rad().size(), 3U);
  EXPECT_WITHIN(limb.borders_rad()[0], 20 * degree, 1e-14, "the first that holds a place counts");
  EXPECT_WITHIN(limb.borders_rad()[1], 90 * degree, 1e-14, "closed form");
  EXPECT_WITHIN(limb.borders_rad()[2], 350 * degree, 1e-14, "closed form");
  EXPECT_EQ(limb.at(0)[0].part, 1U);
  EXPECT_EQ(limb.at(50 * degree)[0].part, 2U);
  EXPECT_EQ(limb.at(180 * degree)[0].part, 0U);
}

}  // namespace
}  // namespace coppermoon::photons
