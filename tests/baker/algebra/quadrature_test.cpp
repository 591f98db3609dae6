// SPDX-License-Identifier: MIT
#include "algebra/quadrature.h"

#include "support/testing.h"

namespace coppermoon::algebra::quadrature_test {

double integral_of_power(int count, int power) {
  double sum = 0;
  for (const auto& [x, weight] : gauss_legendre(count)) sum += weight * std::pow(x, power);
  return sum;
}

double exact_integral_of_power(int power) { return power % 2 ? 0 : 2.0 / (power + 1); }

TEST(GaussLegendre, IsExactUpToDegreeTwiceTheCountMinusOne) {
  for (int count = 1; count <= 64; ++count)
    for (int power = 0; power < 2 * count; ++power)
      EXPECT_WITHIN(integral_of_power(count, power), exact_integral_of_power(power), 2e-14,
                    "rounding, most of it in 1 − x² near the ends")
          << count << " nodes, degree " << power;
}

// The rule's error for x^(2n) is 2^(2n+1) (n!)^4 / ((2n + 1) ((2n)!)²), f^(2n) being (2n)!.
TEST(GaussLegendre, MissesTheNextDegreeByTheTextbookError) {
  for (int n = 1; n <= 10; ++n) {
    const double error = std::exp2(2 * n + 1) * std::pow(std::tgamma(n + 1), 4) /
                         ((2 * n + 1) * std::pow(std::tgamma(2 * n + 1), 2));
    EXPECT_WITHIN(exact_integral_of_power(2 * n) - integral_of_power(n, 2 * n), error, 2e-14,
                  "rounding, as above");
  }
}

// Abramowitz & Stegun (1964), table 25.4: largest node and its weight; of 64 nodes the smallest.
TEST(GaussLegendre, HasThePrintedNodesAndWeights) {
  constexpr auto digits = "printed to 15 digits, rounding of 1 − x² near the ends";
  EXPECT_WITHIN(gauss_legendre(5).back().x, 0.906179845938664, 2e-15, digits);
  EXPECT_WITHIN(gauss_legendre(5).back().weight, 0.236926885056189, 2e-15, digits);
  EXPECT_WITHIN(gauss_legendre(20).back().x, 0.993128599185095, 2e-15, digits);
  EXPECT_WITHIN(gauss_legendre(20).back().weight, 0.017614007139152, 2e-15, digits);
  EXPECT_WITHIN(gauss_legendre(64)[32].x, 0.024350292663424, 2e-15, digits);
  EXPECT_WITHIN(gauss_legendre(64)[32].weight, 0.048690957009140, 2e-15, digits);
}

TEST(GaussLegendre, IsSymmetricWithRisingNodesAndPositiveWeights) {
  for (int count = 1; count <= 64; ++count) {
    const auto nodes = gauss_legendre(count);
    ASSERT_EQ(nodes.size(), static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      EXPECT_WITHIN(nodes[i].x, -nodes[nodes.size() - 1 - i].x, 2e-16, "rounding");
      EXPECT_GT(nodes[i].weight, 0);
      EXPECT_LT(i > 0 ? nodes[i - 1].x : -1, nodes[i].x);
    }
  }
}

TEST(GaussLegendre, RefusesACountOutsideItsRange) {
  EXPECT_THROW(gauss_legendre(0), Error);
  EXPECT_THROW(gauss_legendre(65), Error);
  EXPECT_THROW(gauss_legendre(-1), Error);
}

}  // namespace coppermoon::algebra::quadrature_test
