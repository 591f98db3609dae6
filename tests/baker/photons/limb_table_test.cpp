// SPDX-License-Identifier: MIT
#include "photons/limb_table.h"

#include "support/testing.h"

namespace coppermoon::photons::limb_table_test {

using atmosphere::Column;
using atmosphere::Optics;

constexpr double radius_m = 6.378e6;

const Column full{.density = atmosphere::Density::us_1976,
                  .ozone_du = 345,
                  .ozone_path = atmosphere::OzonePath::bent,
                  .dust_extinction_per_m = 1e-6,
                  .tropospheric_optical_depth = 0.07,
                  .stratosphere = atmosphere::StratosphericAerosol::background,
                  .cloud_top_m = 10.4e3,
                  .cloud_cover = 0.7};

std::vector<Optics> optics_of(std::initializer_list<double> wavelengths_nm) {
  std::vector<Optics> optics;
  for (const double nm : wavelengths_nm)
    optics.push_back(atmosphere::sea_level_optics(algebra::nanometres(nm)));
  return optics;
}

/// d(n r)/dr = n + r dn/dr, with (n − 1) as ρ/ρ₀.
TEST(OpticalExcess, HasTheSlopeOfItsValue) {
  constexpr double step_m = 1;
  for (const auto& column : {Column{}, full})
    for (const double h : {2e3, 8e3, 15e3, 25e3, 35e3}) {
      const auto value = [&](double m) { return optical_excess_m(column, radius_m, m).value; };
      EXPECT_WITHIN_RELATIVE(value(h), atmosphere::density_ratio(column, h).value * (radius_m + h),
                             1e-14, "rounding");
      EXPECT_WITHIN_RELATIVE(optical_excess_m(column, radius_m, h).slope_per_m,
                             (value(h + step_m) - value(h - step_m)) / (2 * step_m), 1e-6,
                             "its third derivative over a metre, and rounding");
    }
}

void expect_accuracy(const Column& column, int rays, double of_depth) {
  const double error = 10. / rays / rays;
  const auto optics = optics_of({380, 425, 510, 655, 780});
  const LimbTable table(column, radius_m, optics, rays);
  for (const auto& o : optics) {
    const auto fan = table.fan(o, column);
    for (std::size_t i = 0; i < fan.tangent_height_m.size(); i += 3) {
      const auto path = limb_path(fan.tangent_height_m[i], radius_m, column, o.refractivity);
      const double depth = atmosphere::product(path.amounts, atmosphere::spectra(column, o));
      EXPECT_WITHIN(fan.impact_height_m[i], path.impact_height_m, 1e-7, "rounding");
      EXPECT_WITHIN(fan.bending_rad[i], path.bending_rad, error * 1e-3, "as the header says")
          << fan.tangent_height_m[i];
      EXPECT_WITHIN(fan.optical_depth[i], depth, of_depth * std::max(1., depth / 4),
                    "as the header says")
          << fan.tangent_height_m[i];
    }
  }
}

TEST(LimbTable, IsTheRayItselfAtEveryWavelengthAndHeight) {
  Column air = full;
  air.ozone_du = 0;
  air.stratosphere = atmosphere::StratosphericAerosol::none;
  for (const int rays : {100, 300, 1000}) expect_accuracy(air, rays, 10. / rays / rays);
}

TEST(LimbTable, RoundsTheKneesOfOzoneAndAerosol) {
  for (const int rays : {100, 300, 1000}) expect_accuracy(full, rays, 1e-3);
}

TEST(LimbTable, FollowsMoreRaysWhereLessErrorIsAsked) {
  const auto optics = optics_of({380, 780});
  const auto followed = [&](int rays) {
    return LimbTable(full, radius_m, optics, rays).followed();
  };
  EXPECT_LT(followed(50), followed(300));
  EXPECT_LT(followed(300), followed(3000));
}

TEST(LimbTable, KnowsTheSameAirWithOtherAmounts) {
  constexpr int rays = 300;
  auto other = full;
  other.ozone_du *= 0.3;
  other.dust_extinction_per_m = 0;
  const auto green = optics_of({550})[0];
  const auto fan = LimbTable(full, radius_m, optics_of({380, 780}), rays).fan(green, other);
  for (std::size_t i = 0; i < fan.tangent_height_m.size(); i += 3) {
    const auto path = limb_path(fan.tangent_height_m[i], radius_m, other, green.refractivity);
    const double depth = atmosphere::product(path.amounts, atmosphere::spectra(other, green));
    EXPECT_WITHIN(fan.bending_rad[i], path.bending_rad, 1e-3 * 10. / rays / rays,
                  "as the header says");
    EXPECT_WITHIN(fan.optical_depth[i], depth, 1e-3 * std::max(1., depth / 4),
                  "as the header says");
  }
}

TEST(LimbTable, StandsOnTheGroundTheTopAndEveryBreak) {
  const auto fan = LimbTable(full, radius_m, optics_of({550}), 60).fan(optics_of({550})[0], full);
  EXPECT_EQ(fan.tangent_height_m.front(), 0);
  EXPECT_EQ(fan.tangent_height_m.back(), 86e3);
  EXPECT_TRUE(std::ranges::is_sorted(fan.tangent_height_m));
  for (const double h : {10.4e3, 15e3, 20e3})
    EXPECT_EQ(std::ranges::count(fan.tangent_height_m, h), 1) << h;
}

TEST(LimbTable, IsCloudyBelowTheCloudsTopAndNowhereElse) {
  const auto fan = LimbTable(full, radius_m, optics_of({550}), 60).fan(optics_of({550})[0], full);
  ASSERT_EQ(fan.filter.size() + 1, fan.tangent_height_m.size());
  for (std::size_t i = 0; i < fan.filter.size(); ++i)
    EXPECT_WITHIN(fan.filter[i], fan.tangent_height_m[i] < 10.4e3 ? 0.3 : 1., 1e-15, "rounding");
}

TEST(LimbTable, WithoutRefractionBendsNothing) {
  Column straight = full;
  straight.refraction = false;
  const auto fan =
      LimbTable(straight, radius_m, optics_of({550}), 60).fan(optics_of({550})[0], straight);
  for (const double bending : fan.bending_rad) EXPECT_EQ(bending, 0);
  EXPECT_EQ(fan.impact_height_m, fan.tangent_height_m);
}

}  // namespace coppermoon::photons::limb_table_test
