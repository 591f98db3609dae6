// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "algebra/progress.h"
#include "uses/tradeoff/sweeps.h"
#include "uses/tradeoff/yardstick.h"

namespace coppermoon::uses {

/// A trial made: its time, and the error of its light.
struct Measured {
  Trial trial;
  std::string_view varied;  ///< name of the setting that its sweep varies
  double value;             ///< value of that setting
  double seconds;
  LightErrors errors;
  bool extrapolated;  ///< from a smaller trial, not made
};

/// Limits of time.
struct RunLimits {
  double longest_s = 20;  ///< longest run [s]
  int repeat = 1;  ///< runs of which the least time counts; three where one is under a second
};

/// Makes every trial of the sweeps, in their order.
///
/// Seconds are those of the solver, tables included; of a texture's width those of the bake, and
/// then the picture's error is that against the widest texture. A trial of photons that would take
/// longer than the limit is extrapolated from smaller ones that differ in photons and step alone: time
/// on a straight line over photons by step, which has what photons do not change, errors as N^(-1/2).
///
/// Omits  that a difference of pictures beyond 10 or so grows slower than the light's error: those
///        extrapolated from it are too small by up to two times
std::vector<Measured> measured_trials(std::span<const Sweep> sweeps, Yardstick& yardstick,
                                      const RunLimits& limits,
                                      const algebra::Progress& progress = {});

}  // namespace coppermoon::uses
