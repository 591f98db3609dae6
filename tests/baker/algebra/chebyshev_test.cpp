// SPDX-License-Identifier: MIT
#include "algebra/chebyshev.h"

#include "support/testing.h"

namespace coppermoon::algebra::chebyshev_test {

double polynomial(const std::vector<double>& powers, double x) {
  double sum = 0;
  for (std::size_t k = powers.size(); k-- > 0;) sum = sum * x + powers[k];
  return sum;
}

/// Values of a function at the nodes.
std::vector<double> at_nodes(int n, double (*function)(double)) {
  std::vector<double> values;
  for (int i = 0; i < n; ++i) values.push_back(function(chebyshev_node(i, n)));
  return values;
}

TEST(ChebyshevNode, IsACosine) {
  for (int i = 0; i < 5; ++i)
    EXPECT_WITHIN(std::abs(chebyshev_node(i, 5)),
                  std::abs(std::cos(std::numbers::pi * (2 * i + 1) / 10)), 1e-15, "closed form");
  EXPECT_LT(chebyshev_node(0, 5), chebyshev_node(4, 5)) << "from -1 to 1";
}

TEST(ChebyshevSeries, OfAPolynomialHasItsCoefficients) {
  // 4 x^3 - 3 x = T3; 2 x^2 - 1 = T2
  const auto series = chebyshev_series(
      at_nodes(6, [](double x) { return 7 + 5 * (2 * x * x - 1) - 2 * (4 * x * x * x - 3 * x); }));
  const double expected[] = {7, 0, 5, -2, 0, 0};
  ASSERT_EQ(series.size(), 6U);
  for (std::size_t k = 0; k < 6; ++k) EXPECT_WITHIN(series[k], expected[k], 1e-13, "rounding");
}

TEST(ChebyshevSeries, OfSeveralComponentsIsThatOfEach) {
  const std::vector<double> sines = at_nodes(6, [](double x) { return std::sin(x); }),
                            squares = at_nodes(6, [](double x) { return x * x; });
  std::vector<std::vector<double>> both;
  for (std::size_t i = 0; i < sines.size(); ++i) both.push_back({sines[i], squares[i]});
  EXPECT_EQ(chebyshev_series(both),
            (std::vector{chebyshev_series(sines), chebyshev_series(squares)}));
}

TEST(PowerSeries, IsTheSamePolynomial) {
  EXPECT_EQ(power_series(std::vector<double>{7, 0, 5, -2}), (std::vector<double>{2, 6, 10, -8}));
  const auto powers =
      power_series(chebyshev_series(at_nodes(9, [](double x) { return std::exp(x); })));
  for (const double x : {-1., -0.3, 0., 0.8, 1.})
    EXPECT_WITHIN(polynomial(powers, x), std::exp(x), 3e-8, "e/(2^8 9!)");
}

}  // namespace coppermoon::algebra::chebyshev_test
