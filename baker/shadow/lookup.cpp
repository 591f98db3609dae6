// SPDX-License-Identifier: MIT
#include "shadow/lookup.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coppermoon::shadow {
namespace {

/// Two neighbours in a list and how far the second counts.
struct Between {
  std::size_t low, high;
  double part;
};

/// The end values hold outside.
Between between(std::span<const double> x, double at) {
  const auto above = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), at) - x.begin());
  if (above == 0) return {0, 0, 0};
  if (above == x.size()) return {above - 1, above - 1, 0};
  return {above - 1, above, (at - x[above - 1]) / (x[above] - x[above - 1])};
}

/// Half a spacing beyond the last place: refracted light is held so far, for rings end there.
double last_distance(std::span<const double> x) {
  return x.size() < 2 ? x.back() : x.back() + (x.back() - x[x.size() - 2]) / 2;
}

std::vector<double> row_sums(const ChannelWeights& weights) {
  std::vector<double> sums;
  for (std::size_t c = 0; c < weights.rows(); ++c) {
    double sum = 0;
    for (const double w : weights.row(c)) sum += w;
    sums.push_back(sum);
  }
  return sums;
}

}  // namespace

Lookup::Lookup(const ChannelWeights& weights) : sunlight_(row_sums(weights)) {}

Lookup::Lookup(const RefractedLight& light, const DirectLight& direct,
               const ChannelWeights& weights, double axis_spacing_m)
    : depths_m_(light.arrangement.depths_m),
      sunlight_(row_sums(weights)),
      sectors_(light.sectors),
      spacing_m_(axis_spacing_m) {
  nodes_ =
      static_cast<std::size_t>(std::ceil(direct.penumbra_m(depths_m_.back()) / spacing_m_)) + 1;
  const std::size_t grids = depths_m_.size() * sectors_;
  values_ = errors_ = algebra::Grid<double>(grids * nodes_, channels());
  tbb::parallel_for(std::size_t{0}, grids, [&](std::size_t g) {
    const double angle =
        2 * std::numbers::pi * static_cast<double>(g % sectors_) / static_cast<double>(sectors_);
    std::vector<double> ratios(weights.columns());
    for (std::size_t n = 0; n < nodes_; ++n) {
      direct.ratios(static_cast<double>(n) * spacing_m_, angle, depths_m_[g / sectors_], ratios);
      fill(light, g, n, ratios, weights);
    }
  });
}

void Lookup::fill(const RefractedLight& light, std::size_t g, std::size_t n,
                  std::span<double> ratios, const ChannelWeights& weights) {
  const double at_m = static_cast<double>(n) * spacing_m_;
  const bool lit = at_m < last_distance(light.axis_distances_m);
  const auto [low, high, part] = between(light.axis_distances_m, at_m);
  std::vector<double> errors(ratios.size());
  for (std::size_t w = 0; lit && w < ratios.size(); ++w) {
    ratios[w] += std::lerp(light.ratio[g](low, w), light.ratio[g](high, w), part);
    errors[w] = std::lerp(light.standard_error[g](low, w), light.standard_error[g](high, w), part);
  }
  for (std::size_t c = 0; c < channels(); ++c) {
    double value = 0;
    for (std::size_t w = 0; w < ratios.size(); ++w) value += weights(c, w) * ratios[w];
    values_(g * nodes_ + n, c) = value;
    errors_(g * nodes_ + n, c) = combined_error(light, errors, weights.row(c));
  }
}

std::span<const double> Lookup::entry(std::size_t plane, std::size_t sector,
                                      std::size_t node) const {
  return values_.row((plane * sectors_ + sector) * nodes_ + node);
}

void Lookup::read(const eclipse::ShadowPlace& place, std::span<double> values) const {
  const double node = algebra::in_metres(place.axis_distance) / spacing_m_;
  const double depth_m = algebra::in_metres(place.depth);
  if (nodes_ == 0 || depth_m <= 0 || node >= static_cast<double>(nodes_ - 1)) {
    std::copy(sunlight_.begin(), sunlight_.end(), values.begin());
    return;
  }
  const auto n = static_cast<std::size_t>(node);
  const double along = node - static_cast<double>(n);
  const auto plane = between(depths_m_, depth_m);
  const double turn = algebra::in_radians(place.position_angle) / (2 * std::numbers::pi) *
                      static_cast<double>(sectors_);
  const double first = std::floor(turn), around = turn - first;
  const auto s0 = static_cast<std::size_t>(first) % sectors_, s1 = (s0 + 1) % sectors_;
  const auto on_plane = [&](std::size_t p, std::size_t c) {
    const double a = std::lerp(entry(p, s0, n)[c], entry(p, s0, n + 1)[c], along);
    if (sectors_ == 1) return a;
    return std::lerp(a, std::lerp(entry(p, s1, n)[c], entry(p, s1, n + 1)[c], along), around);
  };
  for (std::size_t c = 0; c < channels(); ++c)
    values[c] = std::lerp(on_plane(plane.low, c), on_plane(plane.high, c), plane.part);
}

void Lookup::transform(const std::function<void(std::span<double>)>& change) {
  for (std::size_t i = 0; i < values_.rows(); ++i) change(values_.row(i));
  change(sunlight_);
}

double Lookup::worst_relative_error(std::size_t channel, double from_m, double to_m) const {
  double worst = 0;
  for (std::size_t i = 0; i < values_.rows(); ++i) {
    const double at_m = static_cast<double>(i % nodes_) * spacing_m_;
    if (at_m < from_m || at_m > to_m) continue;
    const double value = values_(i, channel);
    worst = std::max(worst, value > 0 ? errors_(i, channel) / value : 1);
  }
  return worst;
}

}  // namespace coppermoon::shadow
