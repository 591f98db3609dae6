// SPDX-License-Identifier: MIT
#include "surface/built_in_map.h"

#include "algebra/table.h"
#include "support/testing.h"
#include "surface/albedo_map.h"

namespace built_in_map_test {

using namespace coppermoon;
using algebra::degrees;
using Map = algebra::Grid<float>;

/// Normal albedo, of a full Moon of geometric albedo 0.12.
const Map& moon() {
  static const Map map = surface::normalised_to_geometric_albedo(
      surface::built_in_map(), surface::Photometry::lommel_seeliger_rolo);
  return map;
}

double at(double latitude, double longitude) {
  return surface::sampled(moon(), {degrees(latitude), degrees(longitude)});
}

/// Mean over a patch of four by four degrees, or another width.
double around(double latitude, double longitude, double width = 4) {
  double sum = 0;
  for (int y = -10; y <= 10; ++y)
    for (int x = -10; x <= 10; ++x)
      sum += at(latitude + width * y / 20, longitude + width * x / 20) / 441;
  return sum;
}

TEST(BuiltInMap, HasItsMariaWhereTheyAre) {
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
        Pair{"Procellarum", 18, -57, 30, -100}, Pair{"Frigoris", 58, 0, 70, 0},
        Pair{"Moscoviense", 27, 148, 10, 160}, Pair{"Orientale", -19.9, -94.7, -20, -105}})
    EXPECT_LT(around(p.latitude, p.longitude),
              0.8 * around(p.highland_latitude, p.highland_longitude))
        << p.name;
}

TEST(BuiltInMap, HasItsBrightCratersWhereTheyAre) {
  EXPECT_GT(at(-43.3, -11.4), 0.2) << "Tycho";
  EXPECT_GT(at(9.6, -20.1), 1.5 * at(3, -27)) << "Copernicus in Mare Insularum";
  EXPECT_GT(at(23.7, -47.5), 1.5 * at(20, -55)) << "Aristarchus in Oceanus Procellarum";
  EXPECT_LT(at(51.6, -9.4), 0.1) << "Plato is dark";
}

/// Cells of ten degrees, of the near side, over their mean.
TEST(BuiltInMap, HasTheContrastThatACameraMeasured) {
  std::ifstream file(COPPERMOON_TEST_DATA "/baker/surface/data/normal_albedo_sato.csv");
  const auto measured =
      algebra::parse_table(std::string(std::istreambuf_iterator(file), {}), "normal_albedo_sato");
  std::vector<double> ratios;
  for (std::size_t i = 0; i < measured["latitude"].size(); ++i)
    if (const double longitude = measured["longitude"][i]; std::abs(longitude) < 80)
      ratios.push_back(around(measured["latitude"][i], longitude, 10) /
                       measured["normal_albedo"][i]);
  ASSERT_EQ(ratios.size(), 224U);
  const double mean = std::accumulate(ratios.begin(), ratios.end(), 0.) / 224;
  double squares = 0;
  for (const double ratio : ratios) squares += std::pow(ratio / mean - 1, 2) / 224;
  EXPECT_WITHIN(std::sqrt(squares), 0, 0.05, "of cells of one degree 5 % rms");
}

TEST(BuiltInMap, IsOfTheMoonsBrightness) {
  EXPECT_WITHIN_RELATIVE(
      surface::geometric_albedo(moon(), surface::Photometry::lommel_seeliger_rolo), 0.12, 1e-3,
      "normalised_to_geometric_albedo: 1e-3");
  for (const float value : moon().values()) {
    ASSERT_GT(value, 0.03F);
    ASSERT_LT(value, 0.35F);
  }
}

TEST(BuiltInMap, TheNearSideIsDarkerThanTheFar) {
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

TEST(BuiltInMap, HasNoSeam) {
  const std::size_t last = moon().columns() - 1;
  double other_steps = 0;
  for (std::size_t c = 0; c < 20; ++c)
    other_steps =
        std::max({other_steps, step_between(c, c + 1), step_between(last - 1 - c, last - c)});
  EXPECT_LT(step_between(last, 0), 1.2 * other_steps) << "no more than between columns nearby";
}

TEST(BuiltInMap, HasNoPinchAtThePoles) {
  for (const std::size_t r : {std::size_t{0}, moon().rows() - 1}) {
    const auto row = moon().row(r);
    double steps = 0, sum = 0;
    for (std::size_t c = 1; c < row.size(); ++c)
      steps += std::abs(row[c] - row[c - 1]), sum += row[c];
    EXPECT_LT(steps / sum, 0.01) << "texels two metres apart: what the JPEG's steps leave";
  }
}

TEST(BuiltInMap, IsTheSameWheneverItIsAskedFor) {
  EXPECT_TRUE(
      std::ranges::equal(surface::built_in_map().values(), surface::built_in_map().values()));
}

}  // namespace built_in_map_test
