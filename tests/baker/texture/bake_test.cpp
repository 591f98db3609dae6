// SPDX-License-Identifier: MIT
#include "texture/bake.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "algebra/error.h"
#include "shadow/by_quadrature.h"
#include "support/within.h"
#include "surface/albedo_map.h"
#include "surface/photometry.h"

namespace coppermoon::texture {
namespace {

const auto february_2008 = almanac::instant_from_utc("2008-02-21T03:08:26Z");

algebra::Grid<float> uniform(std::size_t rows, float albedo = 0.1F) {
  return {rows, 2 * rows, albedo};
}

shadow::Lookup sunlight(double radiance) {
  return shadow::Lookup(shadow::ChannelWeights(1, 1, radiance));
}

std::size_t row_of(double latitude_deg, std::size_t rows) {
  return static_cast<std::size_t>((90 - latitude_deg) / 180 * static_cast<double>(rows));
}
std::size_t column_of(double longitude_deg, std::size_t rows) {
  return static_cast<std::size_t>((180 + longitude_deg) / 180 * static_cast<double>(rows));
}

TEST(Bake, LightsTheSubSolarPointByTheInverseSquareOfItsDistance) {
  const auto sky = almanac::sky_at(february_2008);
  const auto moon = bake(uniform(180), sky, sunlight(1000), {"Y"}, 180);
  const double sun_m = glm::length(sky.sun_m - sky.moon_m) - 1.7374e6;
  const double near = almanac::astronomical_unit_m / sun_m;
  const float lit = moon(row_of(algebra::in_degrees(sky.sub_solar.latitude), 180),
                         column_of(algebra::in_degrees(sky.sub_solar.longitude), 180), 0);
  EXPECT_WITHIN_RELATIVE(lit, 0.1 * 1000 * near * near, 1e-5,
                         "float texels; mu is 1 − 1e-4 within a texel, f 1 − 1e-5");
}

TEST(Bake, FollowsThePhotometricFunctionAwayFromIt) {
  const auto sky = almanac::sky_at(february_2008);
  const std::size_t rows = 360;
  const auto moon = bake(uniform(rows), sky, sunlight(1), {"Y"}, rows);
  const auto sun = almanac::selenographic_direction(sky.sub_solar);
  for (const double longitude : {-70., -30., 20., 60., 80.}) {
    const std::size_t r = row_of(20, rows), c = column_of(longitude, rows);
    const double mu =
        glm::dot(almanac::selenographic_direction(surface::texel_centre(r, c, rows)), sun);
    const float at_sub_solar = moon(row_of(0.1, rows), column_of(5, rows), 0);
    EXPECT_WITHIN(moon(r, c, 0) / at_sub_solar, surface::radiance_factor_yapo_cutler(mu), 3e-4,
                  "the Sun's parallax over the Moon's radius: 1.2e-5 in mu, up to ten times that "
                  "in f; 2.3e-5 in distance");
  }
}

TEST(Bake, LeavesTheFarSideDark) {
  const auto moon = bake(uniform(90), almanac::sky_at(february_2008), sunlight(1), {"Y"}, 90);
  EXPECT_EQ(moon(45, 0, 0), 0);
  EXPECT_EQ(moon(45, 179, 0), 0);
  EXPECT_GT(moon(45, 90, 0), 0);
}

TEST(Bake, DarkensTheSideThatIsDeeperInTheShadow) {
  // At 03:08 the Moon has just entered: it moves east, so its eastern (celestial) limb is deepest;
  // the Moon is south of the axis, so north is deeper than south. Celestial east is the Moon's
  // western hemisphere, longitude negative.
  const auto sky = almanac::sky_at(february_2008);
  const std::vector<double> waves{600};
  std::vector<double> distances;
  for (double d = 0; d < 9e6; d += 1e5) distances.push_back(d);
  const auto light = shadow::by_quadrature({}, {1.479e11, {3.82e8, 3.83e8}}, waves, distances);
  const auto moon =
      bake(uniform(180), sky, shadow::Lookup(light, 6.42e6, shadow::ChannelWeights(1, 1, 1)), {"Y"},
           180);
  const auto at = [&](double latitude, double longitude) {
    return moon(row_of(latitude, 180), column_of(longitude, 180), 0);
  };
  EXPECT_LT(at(50, -50), at(0, 0));
  EXPECT_LT(at(0, 0), at(-50, 50));
  EXPECT_LT(at(0, -60), at(0, 60));
  EXPECT_LT(at(60, 0), at(-60, 0));
}

TEST(Resized, KeepsTheMeanOfASmallerMap) {
  algebra::Grid<float> map(7 * 9, 14 * 9);
  for (std::size_t i = 0; i < map.values().size(); ++i)
    map.values()[i] = static_cast<float>((i * 7919) % 101);
  const auto mean = [](const algebra::Grid<float>& m) {
    return std::accumulate(m.values().begin(), m.values().end(), 0.) /
           static_cast<double>(m.values().size());
  };
  for (const std::size_t rows : {2U, 7U, 10U, 62U})
    EXPECT_WITHIN_RELATIVE(mean(resized(map, rows)), mean(map), 1e-5, "float texels");
}

TEST(Resized, ToItsOwnSizeIsTheMap) {
  algebra::Grid<float> map(3, 6);
  map(1, 4) = 2;
  EXPECT_EQ(resized(map, 3)(1, 4), 2);
}

TEST(Resized, KeepsAPointInItsPlaceWhenLarger) {
  algebra::Grid<float> map(10, 20);
  map(3, 14) = 1;
  const auto large = resized(map, 50);
  double x = 0, y = 0, sum = 0;
  for (std::size_t r = 0; r < 50; ++r)
    for (std::size_t c = 0; c < 100; ++c) {
      sum += large(r, c);
      x += large(r, c) * (static_cast<double>(c) + 0.5);
      y += large(r, c) * (static_cast<double>(r) + 0.5);
    }
  EXPECT_WITHIN(x / sum / 5, 14.5, 1e-5, "bilinear weights are symmetric");
  EXPECT_WITHIN(y / sum / 5, 3.5, 1e-5, "bilinear weights are symmetric");
}

TEST(Resized, RefusesWhatIsNoMap) {
  EXPECT_THROW(resized(algebra::Grid<float>(10, 10), 5), algebra::Error);
  EXPECT_THROW(resized(uniform(4), 1), algebra::Error);
  EXPECT_THROW(resized(uniform(4), 20000), algebra::Error);
}

}  // namespace
}  // namespace coppermoon::texture
