// SPDX-License-Identifier: MIT
#include "uses/picture/horizon_crossings.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "uses/picture/view.h"

namespace coppermoon::uses {
namespace {

using almanac::Instant;

constexpr double step_s = 1800;

double height(const almanac::Observer& place, const Instant& when) {
  return algebra::in_radians(above_horizon(place, almanac::sky_at(when)));
}

/// Zero of the height between two moments, by bisection to 0.02 s.
Crossing crossing(const almanac::Observer& place, Instant from, double seconds) {
  const bool up = height(place, from) > 0;
  while (seconds > 0.02) {
    seconds /= 2;
    const auto middle = almanac::later(from, seconds);
    if ((height(place, middle) > 0) == up) from = middle;
  }
  return {from, !up};
}

/// Times [s from the first moment] and heights [rad]: every half hour, and at extremes so near the horizon that a rise
/// and a set may lie within a step.
std::vector<std::pair<double, double>> heights(const almanac::Observer& place, const Instant& from,
                                               double seconds) {
  constexpr double grazing = 3e-3;  // largest rise within a step: (2π / a day · half a step)² / 2
  const auto steps = static_cast<int>(std::ceil(seconds / step_s));
  const double step = seconds / steps;
  const auto at = [&](double s) { return std::pair{s, height(place, almanac::later(from, s))}; };
  std::vector<std::pair<double, double>> all;
  for (int i = 0; i <= steps; ++i) all.push_back(at(i * step));
  for (int i = 1; i < steps; ++i) {
    const auto n = static_cast<std::size_t>(i);
    const double before = all[n - 1].second, here = all[n].second, after = all[n + 1].second;
    const double bend = before - 2 * here + after;
    if (std::abs(here) < grazing && (here - before) * (here - after) > 0)
      all.push_back(at(i * step + step * (before - after) / (2 * bend)));
  }
  std::ranges::sort(all);
  return all;
}

}  // namespace

std::vector<Crossing> horizon_crossings(const almanac::Observer& place, const Instant& from,
                                        const Instant& to) {
  std::vector<Crossing> found;
  const auto all = heights(place, from, almanac::seconds_between(from, to));
  for (std::size_t i = 1; i < all.size(); ++i)
    if ((all[i - 1].second > 0) != (all[i].second > 0))
      found.push_back(
          crossing(place, almanac::later(from, all[i - 1].first), all[i].first - all[i - 1].first));
  return found;
}

}  // namespace coppermoon::uses
