// SPDX-License-Identifier: MIT
#include "algebra/interpolation.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace coppermoon::algebra {

double interpolated(std::span<const double> x, std::span<const double> y, double at) {
  assert(!x.empty() && x.size() == y.size());
  const auto above = std::upper_bound(x.begin(), x.end(), at);
  if (above == x.begin()) return y.front();
  if (above == x.end()) return y.back();
  const auto i = static_cast<std::size_t>(above - x.begin());
  const double t = (at - x[i - 1]) / (x[i] - x[i - 1]);
  return y[i - 1] + t * (y[i] - y[i - 1]);
}

double mean_between(std::span<const double> x, std::span<const double> y, double from, double to) {
  assert(to > from);
  double sum = 0, left = from;
  auto next = std::upper_bound(x.begin(), x.end(), from);
  while (left < to) {
    const double right = next == x.end() ? to : std::min(to, *next);
    sum += (right - left) * (interpolated(x, y, left) + interpolated(x, y, right)) / 2;
    left = right;
    if (next != x.end()) ++next;
  }
  return sum / (to - from);
}

}  // namespace coppermoon::algebra
