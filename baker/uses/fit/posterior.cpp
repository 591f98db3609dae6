// SPDX-License-Identifier: MIT
#include "uses/fit/posterior.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "algebra/interpolation.h"

namespace coppermoon::uses {
namespace {

using Indices = std::array<std::size_t, 3>;

Indices sizes_of(const Axes& axes) { return {axes[0].size(), axes[1].size(), axes[2].size()}; }

/// Number of steps into which each step of a grid is divided.
constexpr std::size_t refinement = 4;

/// Divides each step of an axis into `refinement` equal steps.
std::vector<double> finer(const std::vector<double>& axis) {
  std::vector<double> all;
  for (std::size_t i = 0; i + 1 < axis.size(); ++i)
    for (std::size_t part = 0; part < refinement; ++part)
      all.push_back(axis[i] +
                    (axis[i + 1] - axis[i]) * static_cast<double>(part) / double{refinement});
  all.push_back(axis.back());
  return all;
}

/// Interpolates values along one axis of a grid to a refined axis, by cubics through the four nearest points.
///
/// Given  before  product of the numbers of points on all axes before this one
std::vector<double> finer_along(const std::vector<double>& axis, std::size_t before,
                                const std::vector<double>& values) {
  const auto places = finer(axis);
  const std::size_t count = axis.size(), nodes = std::min<std::size_t>(4, count),
                    after = values.size() / before / count;
  std::vector<double> all(before * places.size() * after);
  std::vector<double> weights(nodes);
  for (std::size_t place = 0; place < places.size(); ++place) {
    const auto first = std::min(std::max<std::size_t>(place / refinement, 1) - 1, count - nodes);
    algebra::on_polynomial(std::span(axis).subspan(first, nodes), places[place], weights);
    for (std::size_t b = 0; b < before; ++b)
      for (std::size_t n = 0; n < nodes; ++n)
        for (std::size_t a = 0; a < after; ++a)
          all[(b * places.size() + place) * after + a] +=
              weights[n] * values[(b * count + first + n) * after + a];
  }
  return all;
}

/// Calls `act` for each grid point, with its indices and its serial number. The last axis runs fastest.
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

/// Variance of a uniform prior over the whole axis.
double prior_variance(const std::vector<double>& axis) {
  const double length = axis.back() - axis.front();
  return length * length / 12;
}

}  // namespace

Posterior posterior(const Axes& axes, const std::vector<double>& chi_squared) {
  Posterior result;
  const double least = *std::ranges::min_element(chi_squared);
  result.least_chi_squared = least;
  std::array<std::vector<double>, 3> density;
  for (std::size_t a = 0; a < 3; ++a) density[a].resize(axes[a].size());
  std::array<double, 3> mean{};
  std::array<std::array<double, 3>, 3> moments{};
  double sum = 0;
  for_each_point(axes, [&](const Indices& at, std::size_t place) {
    double mass = std::exp((least - chi_squared[place]) / 2);
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
  constexpr double one_sigma = 0.158655;  // share of a normal distribution below −σ
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

void make_finer(Axes& axes, std::vector<double>& chi_squared) {
  std::size_t before = 1;
  for (auto& axis : axes) {
    chi_squared = finer_along(axis, before, chi_squared);
    axis = finer(axis);
    before *= axis.size();
  }
}

}  // namespace coppermoon::uses
