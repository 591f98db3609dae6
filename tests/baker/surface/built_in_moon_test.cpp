// SPDX-License-Identifier: MIT
#include "surface/built_in_moon.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>

#include "algebra/error.h"
#include "support/within.h"
#include "surface/albedo_map.h"

namespace {

using namespace coppermoon;
using algebra::degrees;
using Map = algebra::Grid<float>;

const Map& moon() {
  static const Map map = surface::built_in_moon(256);
  return map;
}

/// The mean over a patch of four by four degrees.
double around(double latitude, double longitude) {
  double sum = 0;
  for (double y = -2; y <= 2; ++y)
    for (double x = -2; x <= 2; ++x)
      sum += surface::sampled(moon(), {degrees(latitude + y), degrees(longitude + x)}) / 25;
  return sum;
}

TEST(BuiltInMoon, HasItsMariaWhereTheyAre) {
  struct Pair {
    const char* name;
    double latitude, longitude, highland_latitude, highland_longitude;
  };
  // Each sea against highlands at its side; places from any atlas.
  for (const auto& p :
       {Pair{"Imbrium", 35, -18, 60, 60}, Pair{"Serenitatis", 28, 18, 35, 45},
        Pair{"Tranquillitatis", 8, 32, -15, 10}, Pair{"Crisium", 17, 59, 30, 70},
        Pair{"Fecunditatis", -4, 52, -25, 70}, Pair{"Nectaris", -15, 35, -20, 15},
        Pair{"Humorum", -24, -39, -30, -75}, Pair{"Nubium", -20, -15, -30, 15},
        Pair{"Procellarum", 18, -57, 30, -100}, Pair{"Frigoris", 58, 0, 72, 30},
        Pair{"Moscoviense", 27, 148, 10, 160}, Pair{"Orientale", -19, -95, -30, -120}})
    EXPECT_LT(around(p.latitude, p.longitude),
              0.8 * around(p.highland_latitude, p.highland_longitude))
        << p.name;
}

TEST(BuiltInMoon, HasItsBrightCratersWhereTheyAre) {
  const auto at = [](double latitude, double longitude) {
    return surface::sampled(moon(), {degrees(latitude), degrees(longitude)});
  };
  EXPECT_GT(at(-43.3, -11.4), 0.2) << "Tycho";
  EXPECT_GT(at(9.6, -20.1), 1.5 * at(3, -27)) << "Copernicus in Mare Insularum";
  EXPECT_GT(at(23.7, -47.5), 1.5 * at(20, -55)) << "Aristarchus in Oceanus Procellarum";
  EXPECT_LT(at(51.6, -9.4), 0.1) << "Plato is dark";
}

TEST(BuiltInMoon, IsOfTheMoonsBrightness) {
  const double albedo =
      surface::geometric_albedo(moon(), surface::Photometry::lommel_seeliger_rolo);
  EXPECT_WITHIN(albedo, 0.12, 0.02,
                "the geometric albedo in V is 0.12; the table is not fitted to it");
  for (const float value : moon().values()) {
    ASSERT_GT(value, 0.03F);
    ASSERT_LT(value, 0.35F);
  }
}

TEST(BuiltInMoon, TheNearSideIsDarkerThanTheFar) {
  EXPECT_LT(around(10, 0) + around(20, 40) + around(20, -40),
            around(10, 180) + around(20, 140) + around(20, -140));
}

/// The mean step between two columns over all rows.
double step_between(std::size_t column, std::size_t next) {
  double sum = 0;
  for (std::size_t r = 0; r < moon().rows(); ++r)
    sum += std::abs(moon()(r, column) - moon()(r, next)) / static_cast<double>(moon().rows());
  return sum;
}

TEST(BuiltInMoon, HasNoSeam) {
  double other_steps = 0;
  for (std::size_t c = 0; c < 20; ++c)
    other_steps = std::max({other_steps, step_between(c, c + 1), step_between(510 - c, 511 - c)});
  EXPECT_LT(step_between(511, 0), 1.2 * other_steps) << "no more than between columns nearby";
}

TEST(BuiltInMoon, HasNoPinchAtThePoles) {
  // A row next to a pole is a circle of 0.35 degrees: the ground hardly changes along it.
  for (const std::size_t r : {std::size_t{0}, moon().rows() - 1}) {
    const auto [lowest, highest] = std::ranges::minmax_element(moon().row(r));
    EXPECT_WITHIN(*lowest / *highest, 1, 0.12, "texels a few kilometres apart, finest noise 5 %");
  }
}

TEST(BuiltInMoon, IsTheSameMoonAtEverySize) {
  const auto coarse = surface::built_in_moon(64);
  double squares = 0, weight = 0;
  for (std::size_t r = 0; r < 64; ++r)
    for (std::size_t c = 0; c < 128; ++c) {
      double mean = 0;
      for (std::size_t i = 0; i < 16; ++i) mean += moon()(4 * r + i / 4, 4 * c + i % 4) / 16.0;
      const double w = std::cos(algebra::in_radians(surface::texel_centre(r, c, 64).latitude));
      squares += w * std::pow(coarse(r, c) / mean - 1, 2);
      weight += w;
    }
  EXPECT_WITHIN(std::sqrt(squares / weight), 0, 0.08,
                "coasts and rays finer than a texel of 85 km are sampled, not averaged");
}

TEST(BuiltInMoon, IsTheSameForAnyNumberOfThreads) {
  Map alone;
  {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    alone = surface::built_in_moon(256);
  }
  EXPECT_TRUE(std::ranges::equal(alone.values(), moon().values()));
}

TEST(BuiltInMoon, HasASize) {
  EXPECT_EQ(surface::built_in_moon(8).columns(), 16);
  EXPECT_THROW(surface::built_in_moon(7), algebra::Error);
  EXPECT_THROW(surface::built_in_moon(40000), algebra::Error);
}

}  // namespace
