// SPDX-License-Identifier: MIT
#include "uses/fit/limb_weather.h"

#include "atmosphere/presets.h"
#include "shadow/by_quadrature.h"
#include "support/testing.h"

namespace coppermoon::uses::limb_weather_test {

constexpr double sun_m = 1.5e11, depth_m = 3.8e8;

eclipse::ShadowPlace at(double distance_m, double angle_deg) {
  return {.axis_distance = algebra::metres(distance_m),
          .position_angle = algebra::degrees(angle_deg),
          .depth = algebra::metres(depth_m)};
}

// The light of 30 degrees of the limb is what is missing where these are black.
TEST(LimbWeather, SharesAreThoseOfTheLimbsPartsInTheQuadrature) {
  const std::array distances_m{0., 1e6, 2e6, 3e6, 4.2e6};
  const std::array red_nm{620.};
  const auto air = atmosphere::preset("undated", {});
  auto without = air;
  auto black = air.column;
  black.dust_extinction_per_m = 0.01;
  black.dust_bottom_m = 0;
  black.dust_top_m = 8e4;
  without.regions = {{algebra::degrees(45), algebra::degrees(75), black}};
  const auto light = shadow::by_quadrature(air, {sun_m, {depth_m}}, red_nm, distances_m),
             dark = shadow::by_quadrature(without, {sun_m, {depth_m}}, red_nm, distances_m);
  const shadow::Sectors sectors{light.sectors};
  for (std::size_t d = 0; d < distances_m.size(); ++d)
    for (const double angle : {60., 100., 150., 240.}) {
      const auto s = sectors.nearest(angle * std::numbers::pi / 180);
      const double missing = 1 - dark.ratio[s](d, 0) / light.ratio[s](d, 0);
      EXPECT_WITHIN(shares_of_limb(at(distances_m[d], angle), sun_m)[2], missing, 0.05, "Accuracy")
          << distances_m[d] << " m, " << angle;
    }
}

TEST(LimbWeather, IsAllOfTheLightInTheUmbraAndNoneOutside) {
  const auto sum = [](double distance_m) {
    const auto shares = shares_of_limb(at(distance_m, 30), sun_m);
    return std::reduce(shares.begin(), shares.end());
  };
  EXPECT_WITHIN(sum(3e6), 1, 1e-12, "rounding");
  EXPECT_LT(sum(5.5e6), 0.01);
  for (const double share : shares_of_limb(at(0, 0), sun_m))
    EXPECT_WITHIN(share, 1. / weather_sectors, 1e-12, "on the axis all parts are alike");
}

TEST(LimbWeather, ChangesLightAsMuchAsCloudDoes) {
  EXPECT_DOUBLE_EQ(weather_over_usual(0.3), 1);
  EXPECT_DOUBLE_EQ(weather_over_usual(0.6), 2);
  EXPECT_DOUBLE_EQ(weather_over_usual(0), 0.5);
}

TEST(LimbWeather, ChangesFromHourToHourAndIsAsLargeAtEach) {
  const std::array seconds{0., 3600., 7200., 1800.};
  const auto weights = weather_changes(seconds);
  ASSERT_EQ(weights.columns(), 3);
  const auto product_of = [&](std::size_t a, std::size_t b) {
    const auto one = weights.row(a), other = weights.row(b);
    return std::inner_product(one.begin(), one.end(), other.begin(), 0.);
  };
  for (std::size_t hour = 0; hour < 3; ++hour)
    EXPECT_WITHIN(product_of(hour, hour), 1, 1e-12, "rounding");
  EXPECT_WITHIN(product_of(0, 1), 0.8, 1e-12, "rounding");
  EXPECT_WITHIN(product_of(0, 2), 0.64, 1e-12, "rounding");
  EXPECT_LT(product_of(3, 3), 1) << "a mean of two hours";
  EXPECT_EQ(weather_changes(std::array{0., 600.}).columns(), 1) << "within a quarter of an hour";
}

}  // namespace coppermoon::uses::limb_weather_test
