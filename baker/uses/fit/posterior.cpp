// SPDX-License-Identifier: MIT
#include "uses/fit/posterior.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace coppermoon::uses {
namespace {

using Indices = std::array<std::size_t, 3>;

Indices sizes_of(const Axes& axes) { return {axes[0].size(), axes[1].size(), axes[2].size()}; }

/// Calls `act` with the indices of each grid point and its place among all, the last axis running fastest.
template <class Act>
void for_each_point(const Axes& axes, const Act& act) {
  const auto [n0, n1, n2] = sizes_of(axes);
  std::size_t place = 0;
  for (std::size_t i = 0; i < n0; ++i)
    for (std::size_t j = 0; j < n1; ++j)
      for (std::size_t k = 0; k < n2; ++k) act(Indices{i, j, k}, place++);
}

/// Weight of a grid point in the trapezoidal rule.
double width_at(const std::vector<double>& axis, std::size_t i) {
  const double from = i > 0 ? axis[i - 1] : axis[i],
               to = i + 1 < axis.size() ? axis[i + 1] : axis[i];
  return (to - from) / 2;
}

/// Quantile of a density that is linear between grid points.
double quantile(const std::vector<double>& axis, const std::vector<double>& density, double share) {
  std::vector<double> below{0};
  for (std::size_t i = 1; i < axis.size(); ++i)
    below.push_back(below.back() + (density[i] + density[i - 1]) / 2 * (axis[i] - axis[i - 1]));
  const double wanted = share * below.back();
  std::size_t i = 1;
  while (i + 1 < axis.size() && below[i] < wanted) ++i;
  const double from = density[i - 1], slope = density[i] - from, width = axis[i] - axis[i - 1],
               area = (wanted - below[i - 1]) / width;
  const double root = std::sqrt(std::max(0., from * from + 2 * slope * area));
  const double way = from + root > 0 ? 2 * area / (from + root) : 0;
  return axis[i - 1] + width * std::clamp(way, 0., 1.);
}

/// Variance of the uniform prior.
double prior_variance(const std::vector<double>& axis) {
  const double length = axis.back() - axis.front();
  return length * length / 12;
}

}  // namespace

Posterior posterior(const Axes& axes, const std::function<double(const Indices&)>& chi_squared) {
  Posterior result;
  std::vector<double> all(axes[0].size() * axes[1].size() * axes[2].size());
  result.least_chi_squared = std::numeric_limits<double>::infinity();
  for_each_point(axes, [&](const Indices& at, std::size_t place) {
    all[place] = chi_squared(at);
    result.least_chi_squared = std::min(result.least_chi_squared, all[place]);
  });
  std::array<std::vector<double>, 3> density;
  for (std::size_t a = 0; a < 3; ++a) density[a].resize(axes[a].size());
  std::array<double, 3> mean{};
  std::array<std::array<double, 3>, 3> moments{};
  double sum = 0;
  for_each_point(axes, [&](const Indices& at, std::size_t place) {
    double mass = std::exp((result.least_chi_squared - all[place]) / 2);
    for (std::size_t a = 0; a < 3; ++a) mass *= width_at(axes[a], at[a]);
    sum += mass;
    for (std::size_t a = 0; a < 3; ++a) {
      density[a][at[a]] += mass / width_at(axes[a], at[a]);
      mean[a] += mass * axes[a][at[a]];
      for (std::size_t b = 0; b < 3; ++b) moments[a][b] += mass * axes[a][at[a]] * axes[b][at[b]];
    }
  });
  const auto covariance = [&](std::size_t a, std::size_t b) {
    return moments[a][b] / sum - mean[a] * mean[b] / (sum * sum);
  };
  constexpr double one_sigma = 0.158655;  // tail beyond it of a normal distribution
  for (std::size_t a = 0; a < 3; ++a) {
    result.estimates[a] = {quantile(axes[a], density[a], 0.5),
                           quantile(axes[a], density[a], one_sigma),
                           quantile(axes[a], density[a], 1 - one_sigma),
                           std::max(0., 1 - covariance(a, a) / prior_variance(axes[a]))};
    for (std::size_t b = 0; b < 3; ++b)
      result.correlation[a][b] =
          covariance(a, b) / std::sqrt(std::max(1e-300, covariance(a, a) * covariance(b, b)));
  }
  return result;
}

}  // namespace coppermoon::uses
