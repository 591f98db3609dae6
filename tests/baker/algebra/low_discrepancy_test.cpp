// SPDX-License-Identifier: MIT
#include "algebra/low_discrepancy.h"

#include "baker/algebra/chi_squared.h"
#include "support/testing.h"

namespace coppermoon::algebra::low_discrepancy_test {

std::size_t part_of(double coordinate, std::size_t parts) {
  return static_cast<std::size_t>(coordinate * static_cast<double>(parts));
}

TEST(ScrambledBlock, HasOnePointInEach1024thOfEveryDimension) {
  for (const std::uint64_t block : {0U, 1U, 99U}) {
    const auto points = scrambled_block(5, block, most_dimensions);
    for (std::size_t d = 0; d < most_dimensions; ++d) {
      std::vector<int> seen(points_a_block);
      for (std::size_t i = 0; i < points_a_block; ++i) ++seen[part_of(points(i, d), seen.size())];
      for (const int count : seen) ASSERT_EQ(count, 1) << "dimension " << d;
    }
  }
}

TEST(ScrambledBlock, HasOnePointInEveryBoxOfA1024thOfTheFirstThreeDimensions) {
  // Number, radical inverse and Sobol's next coordinate are a (0, 10, 3)-net in base 2: boxes of
  // sides 2^−a, 2^−b, 2^−c with a + b + c = 10.
  const auto points = scrambled_block(7, 3, 3);
  for (std::size_t a = 0; a <= 10; ++a)
    for (std::size_t b = 0; a + b <= 10; ++b) {
      const std::size_t x = 1U << a, y = 1U << b, z = 1U << (10 - a - b);
      std::vector<int> seen(x * y * z);
      for (std::size_t i = 0; i < points_a_block; ++i)
        ++seen[(part_of(points(i, 0), x) * y + part_of(points(i, 1), y)) * z +
               part_of(points(i, 2), z)];
      for (const int count : seen) ASSERT_EQ(count, 1) << a << ' ' << b;
    }
}

TEST(ScrambledBlock, PutsInEveryBoxAtTheOriginNearlyItsShareOfPoints) {
  // The star discrepancy of all pairs of dimensions, over 32 × 32 corners: of random points it is
  // about 0.03, of these one in 1024 for each of a few boxes that the corner cuts.
  const auto points = scrambled_block(1, 2, most_dimensions);
  double worst = 0;
  for (std::size_t d = 0; d < most_dimensions; ++d)
    for (std::size_t e = d + 1; e < most_dimensions; ++e)
      for (double x = 1. / 32; x <= 1; x += 1. / 32)
        for (double y = 1. / 32; y <= 1; y += 1. / 32) {
          int inside = 0;
          for (std::size_t i = 0; i < points_a_block; ++i)
            inside += points(i, d) < x && points(i, e) < y;
          worst = std::max(worst, std::abs(inside / static_cast<double>(points_a_block) - x * y));
        }
  EXPECT_LT(worst, 0.012) << "a third of what chance would give";
}

TEST(ScrambledBlock, HasPointsThatAreEachUniform) {
  // One point of many blocks, within its stratum for dimension 0; one true sampler in a thousand
  // fails.
  for (std::size_t d = 0; d < most_dimensions; ++d) {
    std::vector<int> seen(100);
    for (std::uint64_t block = 0; block < 3000; ++block) {
      const double at = scrambled_block(11, block, most_dimensions)(517, d);
      ++seen[part_of(d == 0 ? at * points_a_block - 517 : at, seen.size())];
    }
    EXPECT_UNIFORM(seen, chi_squared_of_99) << "dimension " << d;
  }
}

TEST(ScrambledBlock, MeansWithoutBiasAndFarCloserThanChance) {
  // ∫ Π (1 + (3 u² − 1)/2) = 1; of 1024 random points the mean would err by √((1.2³ − 1)/1024).
  double sum = 0, squares = 0;
  constexpr int blocks = 200;
  for (int block = 0; block < blocks; ++block) {
    const auto points = scrambled_block(13, static_cast<std::uint64_t>(block), 3);
    double mean = 0;
    for (std::size_t i = 0; i < points_a_block; ++i) {
      double product = 1;
      for (const double u : points.row(i)) product *= 1 + (3 * u * u - 1) / 2;
      mean += product / points_a_block;
    }
    sum += mean - 1;
    squares += (mean - 1) * (mean - 1);
  }
  const double error = std::sqrt(squares / blocks), by_chance = std::sqrt(0.728 / points_a_block);
  EXPECT_LT(error, by_chance / 20);
  EXPECT_WITHIN(sum / blocks, 0., 3.4 * error / std::sqrt(blocks), "one run in a thousand fails");
}

TEST(ScrambledBlock, IsTheSameForTheSameSeedAndBlockAlone) {
  const auto one = scrambled_block(1, 2, 3), again = scrambled_block(1, 2, 3),
             other = scrambled_block(1, 3, 3), elsewhere = scrambled_block(2, 2, 3);
  for (std::size_t i = 0; i < points_a_block; ++i) EXPECT_EQ(one(i, 2), again(i, 2));
  EXPECT_NE(one(5, 2), other(5, 2));
  EXPECT_NE(one(5, 2), elsewhere(5, 2));
}

TEST(ScrambledBlock, RefusesDimensionsItDoesNotHave) {
  EXPECT_THROW(scrambled_block(1, 1, 0), Error);
  EXPECT_THROW(scrambled_block(1, 1, most_dimensions + 1), Error);
}

}  // namespace coppermoon::algebra::low_discrepancy_test
