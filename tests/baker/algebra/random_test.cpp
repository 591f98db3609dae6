// SPDX-License-Identifier: MIT
#include "algebra/random.h"

#include "baker/algebra/chi_squared.h"
#include "support/testing.h"

namespace coppermoon::algebra::random_test {

using Words = std::array<std::uint32_t, 4>;

constexpr std::size_t bin_of(double uniform, int bins) {
  return static_cast<std::size_t>(uniform * bins);
}

// The three known answers printed with Random123 by the generator's authors.
TEST(Philox, GivesTheAuthorsKnownAnswers) {
  constexpr std::uint32_t ones = 0xffffffff;
  EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}), (Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(philox({ones, ones, ones, ones}, {ones, ones}),
            (Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(Random, IsUniform) {
  Random random(1, 2);
  std::array<int, 100> seen{};
  for (int i = 0; i < 1'000'000; ++i) ++seen[bin_of(random.uniform(), 100)];
  EXPECT_UNIFORM(seen, chi_squared_of_99);
}

TEST(Random, FollowsNoNumberByARelatedOne) {
  Random random(3, 4);
  std::array<int, 256> seen{};
  for (int i = 0; i < 500'000; ++i) {
    const auto first = bin_of(random.uniform(), 16);
    ++seen[16 * first + bin_of(random.uniform(), 16)];
  }
  EXPECT_UNIFORM(seen, chi_squared_of_255);
}

TEST(Random, GivesNeighbouringStreamsThatAreUnrelated) {
  std::array<int, 256> seen{};
  for (std::uint64_t i = 0; i < 500'000; ++i) {
    const auto here = bin_of(Random(5, 2 * i).uniform(), 16);
    ++seen[16 * here + bin_of(Random(5, 2 * i + 1).uniform(), 16)];
  }
  EXPECT_UNIFORM(seen, chi_squared_of_255);
}

TEST(Random, HasTheMeanAndVarianceOfTheUnitInterval) {
  Random random(6, 7);
  constexpr int count = 1'000'000;
  double sum = 0, sum_of_squares = 0;
  for (int i = 0; i < count; ++i) {
    const double u = random.uniform() - 0.5;
    sum += u;
    sum_of_squares += u * u;
  }
  EXPECT_WITHIN(sum / count, 0.0, 3.3 * std::sqrt(1.0 / 12 / count), "one run in 1000 exceeds it");
  EXPECT_WITHIN(sum_of_squares / count, 1.0 / 12, 3.3 * std::sqrt(1.0 / 180 / count),
                "the variance of (u − 1/2)² is 1/180; one run in 1000 exceeds it");
}

TEST(Random, CarriesFiftyThreeRandomBits) {
  Random random(8, 9);
  constexpr int count = 100'000;
  std::array<int, 53> ones{};
  for (int i = 0; i < count; ++i) {
    const double u = random.uniform();
    ASSERT_TRUE(u >= 0 && u < 1) << u;
    const auto bits = static_cast<std::uint64_t>(u * 0x1p53);
    ASSERT_EQ(static_cast<double>(bits), u * 0x1p53);
    for (std::size_t b = 0; b < ones.size(); ++b) ones[b] += static_cast<int>(bits >> b & 1);
  }
  for (const int n : ones)
    EXPECT_WITHIN(n, count / 2, 4.3 * std::sqrt(count / 4.0),
                  "53 bits, one run in 1000 exceeds it");
}

TEST(Random, GivesAStreamTheSameNumbersWhoeverAsksWhen) {
  Random alone(10, 11), interleaved(10, 11), other(10, 12);
  for (int i = 0; i < 100; ++i) {
    other.uniform();
    EXPECT_EQ(alone.uniform(), interleaved.uniform());
  }
}

TEST(Random, TellsAllSixtyFourBitsOfSeedAndIndexApart) {
  const double plain = Random(1, 1).uniform();
  for (int bit = 1; bit < 64; ++bit) {
    const std::uint64_t flipped = 1 ^ std::uint64_t{1} << bit;
    EXPECT_NE(Random(flipped, 1).uniform(), plain) << "seed bit " << bit;
    EXPECT_NE(Random(1, flipped).uniform(), plain) << "index bit " << bit;
  }
}

}  // namespace coppermoon::algebra::random_test
