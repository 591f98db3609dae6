// SPDX-License-Identifier: MIT
#include "photons/earth_limb.h"

#include "atmosphere/presets.h"
#include "support/testing.h"

namespace coppermoon::photons::earth_limb_test {

using algebra::degrees;
using std::numbers::pi;

const std::vector<atmosphere::Optics> optics{
    atmosphere::sea_level_optics(algebra::nanometres(450)),
    atmosphere::sea_level_optics(algebra::nanometres(650))};

atmosphere::Atmosphere standard(bool sphere) {
  auto air = atmosphere::preset("undated", degrees(15));
  air.molecules = {};
  if (sphere) air.earth = {};
  return air;
}

TEST(WholeLimb, OfASphereIsOnePartAllAround) {
  const WholeLimb limb(standard(true), optics, 10);
  ASSERT_EQ(limb.parts().size(), 1U);
  EXPECT_EQ(limb.at(2)[0].share, 1);
  EXPECT_EQ(limb.at(2)[1].share, 0);
  const auto series = limb.series(5);
  ASSERT_EQ(series[0].cosine.size(), 1U);
  EXPECT_WITHIN(series[0].cosine[0], 1, 1e-14, "rounding");
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

TEST(WholeLimb, OfAnEllipsoidIsASeriesOfTwoTerms) {
  const auto series = WholeLimb(standard(false), optics, 10).series(40);
  const std::vector<double> equator{0.5, 0, -0.5}, pole{0.5, 0, 0.5};
  for (std::size_t m = 0; m < 3; ++m) {
    EXPECT_WITHIN(series.at(0).cosine.at(m), equator[m], 1e-14, "sin² = 1/2 − cos 2ψ/2");
    EXPECT_WITHIN(series.at(1).cosine.at(m), pole[m], 1e-14, "cos² = 1/2 + cos 2ψ/2");
  }
  EXPECT_EQ(series[0].cosine.size(), 3U);
}

TEST(WholeLimb, ChangesItsColumnsAtTheBordersOfRegions) {
  auto air = standard(true);
  air.regions = {{degrees(350), degrees(20), {}}, {degrees(10), degrees(90), {}}};
  const WholeLimb limb(air, optics, 10);
  const double degree = pi / 180;
  EXPECT_EQ(limb.at(0)[0].part, 1U);
  EXPECT_EQ(limb.at(50 * degree)[0].part, 2U);
  EXPECT_EQ(limb.at(180 * degree)[0].part, 0U);
  const auto series = limb.series(100);
  const auto expect = [&](std::size_t part, double from, double to) {
    EXPECT_WITHIN(series[part].cosine[0], (to - from) / (2 * pi), 1e-13, "the mean");
    for (std::size_t m = 1; m <= 100; ++m) {
      const auto n = static_cast<double>(m);
      EXPECT_WITHIN(series[part].cosine[m], (std::sin(n * to) - std::sin(n * from)) / (n * pi),
                    2e-12, "closed form; below 1e-12 it is 0");
      EXPECT_WITHIN(series[part].sine[m], (std::cos(n * from) - std::cos(n * to)) / (n * pi), 2e-12,
                    "closed form; below 1e-12 it is 0");
    }
  };
  expect(1, -10 * degree, 20 * degree);
  expect(2, 20 * degree, 90 * degree);  // the first region that holds a place counts
}

TEST(WholeLimb, OfBeltsIsEvenAndStraightBetweenThem) {
  auto air = standard(false);
  air.belts = {{0, {}}, {pi / 2, {}}, {pi, {}}};
  const auto series = WholeLimb(air, optics, 10).series(99);
  ASSERT_EQ(series.size(), 3U);
  for (std::size_t m = 1; m < 99; ++m) {
    const auto n = static_cast<double>(m);
    EXPECT_WITHIN(series[0].cosine[m], 4 * (1 - std::cos(n * pi / 2)) / (n * n * pi * pi), 2e-12,
                  "closed form of a triangle; below 1e-12 it is 0");
    for (const auto& part : series) EXPECT_EQ(part.sine[m], 0);
  }
}

}  // namespace coppermoon::photons::earth_limb_test
