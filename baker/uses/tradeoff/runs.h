// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "algebra/progress.h"
#include "uses/tradeoff/sweeps.h"
#include "uses/tradeoff/yardstick.h"

namespace coppermoon::uses {

/// Time and error of a trial.
struct Measured {
  Trial trial;
  std::string_view varied;  ///< name of the setting that its sweep varies
  double value;             ///< value of that setting
  double seconds;
  LightErrors errors;
  bool extrapolated;  ///< from smaller trials
};

/// Runs a trial and gives the seconds that it took.
using Stopwatch = std::function<double(const Trial& trial, const std::function<void()>& run)>;

/// A Stopwatch by the steady clock.
double seconds_of(const Trial& trial, const std::function<void()>& run);

/// Limits on the time of runs.
struct RunLimits {
  double longest_s = 20;  ///< longest run
  int repeat = 1;         ///< runs, of which the shortest counts; three or more where one is short
  double short_s = 1;     ///< time below which a run is short
  Stopwatch stopwatch = seconds_of;
};

/// Limits for trials that take seconds together.
inline const RunLimits quick_limits{.longest_s = 3, .short_s = 0.1};

/// Makes every trial of the sweeps, in their order.
///
/// Seconds are those of the solver, tables included. In a sweep of texture widths they are those of the bake, and the
/// picture's error is relative to the widest texture. A trial of photons that would exceed the limit is extrapolated
/// from smaller ones that differ in photons and step alone: time on a straight line over photons by step, whose
/// intercept is the time of tables; errors as N^(-1/2).
///
/// Omits  saturation of CIEDE2000 beyond 10 or so: values extrapolated from there are too small by up to two times
std::vector<Measured> measured_trials(std::span<const Sweep> sweeps, Yardstick& yardstick,
                                      const RunLimits& limits,
                                      const algebra::Progress& progress = {});

}  // namespace coppermoon::uses
