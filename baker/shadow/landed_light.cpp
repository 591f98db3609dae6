// SPDX-License-Identifier: MIT
#include "shadow/landed_light.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "shadow/irradiance.h"

namespace coppermoon::shadow {
namespace {

constexpr std::size_t row_size = moments * lanes;

/// Largest |k| for which ∫ exp(k t) dt is computed as a power series in k, up to the fifth power, accurate to 1e-7.
constexpr double small = 0.3;

/// The integral ∫ exp(k t) dt from 0 to `part`, for small k.
double exponential_integral(double k, double part) {
  const double x = k * part;
  constexpr double of_x5 = 1. / 720;
  return part * (1 + x * (1. / 2 + x * (1. / 6 + x * (1. / 24 + x * (1. / 120 + x * of_x5)))));
}

/// Mean over an interval of a quantity that varies exponentially from `first` to `last`, with k = ln(last/first).
double exponential_mean(double first, double last, double k) {
  return std::abs(k) > small ? (last - first) / k : first * exponential_integral(k, 1);
}

/// Share of the integral ∫ exp(k t) dt from 0 to 1 that lies below a given t.
class ExponentialShare {
 public:
  explicit ExponentialShare(double k)
      : k_(k),
        is_small_(std::abs(k) <= small),
        over_whole_(1 / (is_small_ ? exponential_integral(k, 1) : std::expm1(-std::abs(k)))) {}

  double operator()(double part) const {
    if (is_small_) return exponential_integral(k_, part) * over_whole_;
    if (k_ < 0) return std::expm1(k_ * part) * over_whole_;
    return std::exp(k_ * (part - 1)) * std::expm1(-k_ * part) * over_whole_;
  }

  /// Factor by which exp(k t) changes when t grows by the given amount.
  double change(double by) const {
    return is_small_ ? 1 + k_ * exponential_integral(k_, by) : std::exp(k_ * by);
  }

 private:
  double k_;
  bool is_small_;
  double over_whole_;
};

/// Rays at one wavelength: the axis distance where they land, in bin widths, and the light they carry. They range from
/// the ground up to two rays beyond the last one that lands within reach. Those two are needed for interpolation.
struct Rays {
  std::vector<double> place, impact_m, depth, transmittance;

  Rays(const photons::Fan& fan, const LandingPlane& plane, double radius_m) {
    std::size_t count = fan.bending_rad.size();
    for (std::size_t i = 0; i < count; ++i) {
      impact_m.push_back(radius_m + fan.impact_height_m[i]);
      place.push_back(
          landing_m(impact_m[i], fan.bending_rad[i], plane.sun_distance_m, plane.depth_m) /
          plane.bin_m);
    }
    const double reach = plane.reach_m / plane.bin_m;
    while (count > 3 && place[count - 3] > reach) --count;
    place.resize(count), impact_m.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      depth.push_back(fan.optical_depth[i]);
      transmittance.push_back(std::exp(-depth[i]));
    }
  }
};

/// Adds light at one wavelength to the sums for a block of wavelengths, in which each wavelength has its own lane.
class Gatherer {
 public:
  /// Given  first, last  bins to gather; no light lands before the first, and light after the last is left out
  Gatherer(double* sums, int first, int last, std::size_t lane)
      : sums_(sums + lane), first_(first), last_(last) {}

  void add(const Rays& rays, std::span<const double> filter) const {
    // FAULT Richardson's step left out: 4. / 3, far = -1. / 3 => 1, far = 0
    constexpr double near = 4. / 3, far = -1. / 3;
    // Intervals between rays are skipped if they carry no light, because they may lie outside the bins.
    const std::size_t last = rays.place.size() - 1;
    for (std::size_t i = 0; i < last; ++i)
      if (filter[i] != 0) add_cell(rays, i, i + 1, near * filter[i]);
    for (std::size_t i = 0; i + 1 < last; i += 2)
      if (filter[i] != 0) add_cell(rays, i, i + 2, far * filter[i]);
  }

 private:
  void add_cell(const Rays& rays, std::size_t i, std::size_t j, double weight) const {
    if (std::min(rays.place[i], rays.place[j]) >= last_) return;
    const double k = rays.depth[i] - rays.depth[j], b0 = rays.impact_m[i], b1 = rays.impact_m[j];
    const double light = weight * (b1 - b0) * (b0 + b1) / 2 *
                         exponential_mean(rays.transmittance[i], rays.transmittance[j], k);
    if (rays.place[i] <= rays.place[j])
      spread(rays.place[i], rays.place[j], light, k);
    else
      spread(rays.place[j], rays.place[i], light, -k);
  }

  /// Adds light that lands between two places, with a density that varies exponentially from one to the other. It
  /// steps from bin to bin with a constant factor, beginning at the brighter end, because light at the other may be 0.
  void spread(double from, double to, double light, double steepness) const {
    const auto bin = static_cast<int>(std::floor(from));
    if (to <= bin + 1) return put(bin, (from + to) / 2, to - from, light);
    const ExponentialShare share(steepness);
    const double a_bin = 1 / (to - from);
    const auto up_to = [&](int end) { return light * share((end - from) * a_bin); };
    const int first = bin + 1, last = std::min(static_cast<int>(std::ceil(to)) - 1, last_);
    put(bin, (from + first) / 2, first - from, up_to(first));
    if (first < last && steepness <= 0) {
      double in_bin = up_to(first + 1) - up_to(first);
      const double change = share.change(a_bin);
      for (int i = first; i < last; ++i, in_bin *= change) put(i, i + 0.5, 1, in_bin);
    } else if (first < last) {
      double in_bin = up_to(last) - up_to(last - 1);
      const double change = share.change(-a_bin);
      for (int i = last - 1; i >= first; --i, in_bin *= change) put(i, i + 0.5, 1, in_bin);
    }
    if (last < last_) put(last, (last + to) / 2, to - last, light - up_to(last));
  }

  /// Adds light that is spread evenly over a bin, or part of a bin, to the sums at the bin's upper boundary.
  void put(int bin, double middle, double width, double light) const {
    double* row = sums_ + static_cast<std::size_t>(bin + 1 - first_) * row_size;
    row[0] += light;
    row[lanes] += light * middle;
    // FAULT the second moment of a bin: width * width / 12 => width * width / 3
    row[2 * lanes] += light * (middle * middle + width * width / 12);
  }

  double* sums_;
  int first_, last_;
};

/// Landing places of the rays, beginning with the lowest ray that carries light, because cloud may stop all rays below
/// its top. If no ray carries light, the result is the landing place of the highest ray alone.
std::span<const double> lit(std::span<const double> places, std::span<const double> filter) {
  const auto lowest = std::ranges::find_if(filter, [](double share) { return share != 0; });
  return places.subspan(
      std::min(static_cast<std::size_t>(lowest - filter.begin()), places.size() - 1));
}

}  // namespace

int LandingPlane::end_of(double farthest) const {
  return static_cast<int>(std::floor(std::min(farthest, reach_m / bin_m))) + 1;
}

LandedLight::LandedLight(std::span<const photons::Fan> fans, const LandingPlane& plane,
                         double radius_m) {
  std::vector<Rays> rays;
  double least = std::numeric_limits<double>::max(), greatest = -least;
  for (const auto& fan : fans) {
    const auto& places = rays.emplace_back(fan, plane, radius_m).place;
    const auto [low, high] = std::ranges::minmax(lit(places, fan.filter));
    least = std::min(least, low), greatest = std::max(greatest, high);
  }
  first_ = static_cast<int>(std::floor(least));
  last_ = std::max(first_, plane.end_of(greatest));
  sums_.resize(static_cast<std::size_t>(last_ - first_ + 1) * row_size);
  for (std::size_t w = 0; w < rays.size(); ++w)
    Gatherer(sums_.data(), first_, last_, w).add(rays[w], fans[w].filter);
  for (std::size_t i = row_size; i < sums_.size(); ++i) sums_[i] += sums_[i - row_size];
}

}  // namespace coppermoon::shadow
