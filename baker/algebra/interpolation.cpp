// SPDX-License-Identifier: MIT
#include "algebra/interpolation.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>

namespace coppermoon::algebra {
namespace {

double slope_between(std::span<const double> x, std::span<const double> y, std::size_t i) {
  return (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
}

double monotone_slope(std::span<const double> x, std::span<const double> y, std::size_t i) {
  if (i == 0) return slope_between(x, y, 0);
  const double before = slope_between(x, y, i - 1);
  if (i + 1 == x.size()) return before;
  const double after = slope_between(x, y, i);
  if (before * after <= 0) return 0;
  const double left = x[i] - x[i - 1], right = x[i + 1] - x[i];
  // FAULT a monotone cubic's weights exchanged: (2 * right + left) => (right + 2 * left)
  return 3 * (left + right) / ((2 * right + left) / before + (right + 2 * left) / after);
}

double least_distance(std::span<const double> x) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < x.size(); ++i) least = std::min(least, x[i + 1] - x[i]);
  return least;
}

}  // namespace

OnLine on_line(std::span<const double> x, double at) {
  assert(!x.empty());
  const auto above = static_cast<std::size_t>(std::ranges::upper_bound(x, at) - x.begin());
  if (above == 0) return {0, 0, 0};
  if (above == x.size()) return {above - 1, above - 1, 0};
  return {above - 1, above, (at - x[above - 1]) / (x[above] - x[above - 1])};
}

double interpolated(std::span<const double> x, std::span<const double> y, double at) {
  assert(x.size() == y.size());
  const auto [below, above, further] = on_line(x, at);
  return y[below] + further * (y[above] - y[below]);
}

double mean_between(std::span<const double> x, std::span<const double> y, double from, double to) {
  assert(to > from);
  double sum = 0, left = from;
  auto next = std::upper_bound(x.begin(), x.end(), from);
  while (left < to) {
    const double right = next == x.end() ? to : std::min(to, *next);
    // FAULT a mean by left ends alone: x, y, right => x, y, left
    sum += (right - left) * (interpolated(x, y, left) + interpolated(x, y, right)) / 2;
    left = right;
    if (next != x.end()) ++next;
  }
  return sum / (to - from);
}

void on_polynomial(std::span<const double> nodes, double at, std::span<double> weights) {
  assert(weights.size() == nodes.size());
  std::ranges::fill(weights, 1);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (std::size_t j = 0; j < nodes.size(); ++j)
      if (j != i) weights[i] *= (at - nodes[j]) / (nodes[i] - nodes[j]);
}

std::vector<double> on_polynomial(std::span<const double> nodes, double at) {
  std::vector<double> weights(nodes.size());
  on_polynomial(nodes, at, weights);
  return weights;
}

OnCircle on_circle(std::size_t count, double turn) {
  if (count == 1) return {{}, {1}};
  constexpr std::array<double, 4> nodes{-1, 0, 1, 2};
  const double before = std::floor(turn), all = static_cast<double>(count);
  OnCircle some{{}, on_polynomial(std::span(nodes), turn - before)};
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double place = before + nodes[i];
    some.at[i] = static_cast<std::size_t>(place - std::floor(place / all) * all);
  }
  return some;
}

MonotoneCubic::MonotoneCubic(std::span<const double> x, std::span<const double> y)
    : end_(x.back()), end_value_(y.back()), cells_per_unit_(1 / least_distance(x)) {
  assert(x.size() >= 2 && x.size() == y.size() && cells_per_unit_ > 0);
  double slope = monotone_slope(x, y, 0);
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    const double width = x[i + 1] - x[i], mean = slope_between(x, y, i);
    const double next = monotone_slope(x, y, i + 1);
    pieces_.push_back({x[i], y[i], slope, (3 * mean - 2 * slope - next) / width,
                       (slope + next - 2 * mean) / (width * width)});
    slope = next;
    const auto cells = static_cast<std::size_t>((x[i + 1] - x[0]) * cells_per_unit_) + 1;
    first_in_cell_.resize(std::max(cells, first_in_cell_.size()), i);
  }
  end_slope_ = slope;
}

double MonotoneCubic::operator()(double at) const {
  const double from_start = at - pieces_.front().from;
  if (!(from_start > 0)) return pieces_.front().value + pieces_.front().slope * from_start;
  if (at >= end_) return end_value_ + end_slope_ * (at - end_);
  const auto* piece =
      &pieces_[first_in_cell_[static_cast<std::size_t>(from_start * cells_per_unit_)]];
  if (piece != &pieces_.back() && at >= piece[1].from) ++piece;
  const double t = at - piece->from;
  return piece->value + t * (piece->slope + t * (piece->second + t * piece->third));
}

}  // namespace coppermoon::algebra
