// SPDX-License-Identifier: MIT
#include "algebra/chebyshev.h"

#include <cmath>
#include <numbers>

namespace coppermoon::algebra {

double chebyshev_node(int i, int n) { return -std::cos(std::numbers::pi * (i + 0.5) / n); }

std::vector<double> chebyshev_series(std::span<const double> values) {
  const int n = static_cast<int>(values.size());
  std::vector<double> coefficients;
  for (int k = 0; k < n; ++k) {
    double sum = 0;
    for (int i = 0; i < n; ++i)
      sum += values[static_cast<std::size_t>(i)] * std::cos(k * std::acos(chebyshev_node(i, n)));
    coefficients.push_back((k == 0 ? 1 : 2) * sum / n);
  }
  return coefficients;
}

std::vector<std::vector<double>> chebyshev_series(const std::vector<std::vector<double>>& values) {
  std::vector<std::vector<double>> series;
  for (std::size_t component = 0; component < values.front().size(); ++component) {
    std::vector<double> one;
    for (const auto& at_node : values) one.push_back(at_node[component]);
    series.push_back(chebyshev_series(one));
  }
  return series;
}

std::vector<double> power_series(std::span<const double> chebyshev) {
  // uses the recurrence of Chebyshev polynomials, T_{k+1} = 2 x T_k − T_{k−1}
  const auto n = chebyshev.size();
  std::vector<double> sum(n), before(n), now(n);
  if (n > 0) now[0] = 1;
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = 0; i < n; ++i) sum[i] += chebyshev[k] * now[i];
    std::vector<double> next(n);
    for (std::size_t i = 0; i < n; ++i)
      next[i] = (i > 0 ? (k == 0 ? 1 : 2) * now[i - 1] : 0) - before[i];
    before = now;
    now = next;
  }
  return sum;
}

}  // namespace coppermoon::algebra
