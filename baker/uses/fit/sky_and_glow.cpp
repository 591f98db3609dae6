// SPDX-License-Identifier: MIT
#include "uses/fit/sky_and_glow.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace coppermoon::uses {
namespace {

/// Robust standard deviation, estimated from the median absolute deviation, so that outliers have little effect.
double spread_of(AroundTheDisc values) {
  constexpr double of_normal = 1.4826;
  const double middle = median_of(values);
  for (double& value : values) value = std::abs(value - middle);
  return of_normal * median_of(values);
}

/// A pixel in the ring around the disc, and the sector of the ring it lies in.
struct RingPixel {
  std::size_t pixel, sector;
};

std::vector<RingPixel> ring_pixels() {
  const double middle = fit_side_px / 2., radius = fit_disc_share * middle;
  const std::size_t sectors = AroundTheDisc().size();
  std::vector<RingPixel> ring;
  for (std::size_t r = 0; r < fit_side_px; ++r)
    for (std::size_t c = 0; c < fit_side_px; ++c) {
      const double x = static_cast<double>(c) + 0.5 - middle,
                   y = static_cast<double>(r) + 0.5 - middle, away = std::hypot(x, y);
      if (away <= 1.12 * radius || away >= 1.24 * radius) continue;
      const double turn = std::atan2(y, x) / (2 * std::numbers::pi) + 0.5;
      ring.push_back(
          {r * fit_side_px + c,
           std::min(static_cast<std::size_t>(turn * static_cast<double>(sectors)), sectors - 1)});
    }
  return ring;
}

}  // namespace

AroundTheDisc around_the_disc(const algebra::Grid<float>& picture) {
  static const auto ring = ring_pixels();
  AroundTheDisc sums{}, counts{};
  for (const auto& [pixel, sector] : ring) {
    sums[sector] += picture.values()[pixel];
    ++counts[sector];
  }
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] /= counts[i];
  return sums;
}

double median_of(AroundTheDisc around) {
  std::ranges::sort(around);
  return (around[around.size() / 2 - 1] + around[around.size() / 2]) / 2;
}

SkyAndGlow sky_and_glow(const AroundTheDisc& light, const AroundTheDisc& glow,
                        const Uncertain& factor) {
  constexpr int passes = 8;
  constexpr double outlier = 4.685, least_error = 1e-12;
  double sky = 0, more = factor.value, variance = factor.error * factor.error;
  AroundTheDisc left{};
  const auto take_off = [&] {
    for (std::size_t i = 0; i < left.size(); ++i) left[i] = light[i] - more * glow[i];
    sky = median_of(left);
    for (double& value : left) value -= sky;
  };
  take_off();
  double error = 0;
  for (int pass = 0; pass < passes; ++pass) {
    error = std::max(spread_of(left), least_error);
    double w = 0, x = 0, xx = 0, y = 0, xy = 0;  // sums for the regression of light on glow
    for (std::size_t i = 0; i < left.size(); ++i) {
      const double off = left[i] / (outlier * error), inner = std::max(0., 1 - off * off),
                   weight = inner * inner;
      w += weight;
      x += weight * glow[i];
      xx += weight * glow[i] * glow[i];
      y += weight * light[i];
      xy += weight * glow[i] * light[i];
    }
    const double information = (xx - x * x / w) / (error * error),
                 before = 1 / (factor.error * factor.error);
    variance = 1 / (information + before);
    more = variance * ((xy - x * y / w) / (error * error) + before * factor.value);
    more = std::max(0., more);
    take_off();
  }
  return {{sky, error}, {more, std::sqrt(variance)}};
}

}  // namespace coppermoon::uses
