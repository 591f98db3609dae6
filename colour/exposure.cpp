// SPDX-License-Identifier: MIT
#include "colour/exposure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "algebra/error.h"

namespace coppermoon::colour {
namespace {

/// Exposure times that cameras show [s], or reciprocals of such times, in steps of a third and of half a stop. A time
/// in both series, such as 1/20 s, counts as one in thirds, the default on cameras.
constexpr std::array times_in_thirds{
    1.,    1.25, 1.3,  1.6,   1 / .6, 2.,   2.5,    3.,   3.2, 1 / .3, 4.,    5.,   6.,
    8.,    10.,  13.,  15.,   20.,    25.,  30.,    40.,  50., 60.,    80.,   100., 125.,
    160.,  200., 250., 320.,  400.,   500., 640.,   800., 1e3, 1250.,  1600., 2e3,  2500.,
    3200., 4e3,  5e3,  6400., 8e3,    1e4,  12800., 16e3, 2e4, 25600., 32e3};
constexpr std::array times_in_halves{1 / .7, 1.5,  11.,   45.,   90.,  180.,
                                     350.,   750., 1500., 3000., 6000.};

/// Rounds a number of stops to the given steps per stop. Returns nothing if rounding changes it by more than `most`.
std::optional<double> rounded(double stops, double steps, double most) {
  const double nearest = std::round(stops * steps) / steps;
  return std::abs(nearest - stops) <= most ? std::optional(nearest) : std::nullopt;
}

bool is_in(std::span<const double> series, double time_s) {
  constexpr double alike = 0.005;
  return std::ranges::any_of(series, [=](double shown) {
    return std::abs(std::max(time_s, 1 / time_s) / shown - 1) < alike;
  });
}

}  // namespace

double real_time_s(double shown_s) {
  constexpr double longest_s = 30;
  const double steps = is_in(times_in_thirds, shown_s)   ? 3
                       : is_in(times_in_halves, shown_s) ? 2
                                                         : 0;
  if (steps == 0 || shown_s > longest_s) return shown_s;
  return std::exp2(std::round(std::log2(shown_s) * steps) / steps);
}

double real_f_number(double shown) {
  constexpr double most = 0.1;
  const double stops = 2 * std::log2(shown);
  return std::exp2(rounded(stops, 3, most).value_or(rounded(stops, 2, most).value_or(stops)) / 2);
}

double real_iso(double shown) {
  constexpr double base = 100, most = 0.03;
  const double stops = std::log2(shown / base);
  return base * std::exp2(rounded(stops, 3, most).value_or(stops));
}

double exposure_scale(const Exposure& exposure) {
  const auto& [t, N, S] = exposure;
  algebra::require_within("exposure time [s]", t, 1e-6, 1e6);
  algebra::require_within("f-number", N, 0.5, 512);
  algebra::require_within("ISO speed", S, 1, 1e7);
  // FAULT exposure 1 % off: q = 0.65 => q = 0.6565
  constexpr double q = 0.65;
  return q * t * S / (saturation_exposure_lx_s * N * N);
}

}  // namespace coppermoon::colour
