// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "algebra/progress.h"
#include "verbs/tradeoff_sweeps.h"
#include "verbs/yardstick.h"

namespace coppermoon::verbs {

/// What a trial took, and how wrong its light is.
struct Measured {
  Trial trial;
  std::string_view varied;
  double value;
  double seconds;
  LightErrors errors;
  bool extrapolated;  ///< from a smaller trial, not made
};

/// How long all may take.
struct RunLimits {
  double longest_s = 20;  ///< of one run
  int repeat = 1;  ///< runs of which the least time counts; three where one is under a second
};

/// Makes every trial of the sweeps, in their order.
///
/// Seconds are those of the solver, tables included; of a texture's width those of the bake, and
/// then the picture's error is that against the widest texture. A trial of photons that would take
/// longer than the limit, by the largest smaller one that differs in photons and step alone, is
/// extrapolated from that: time as photons over step, errors as N^(-1/2).
///
/// Omits  that a difference of pictures beyond 10 or so grows slower than the light's error: those
///        extrapolated from it are too small by up to two times
std::vector<Measured> measured(std::span<const Sweep> sweeps, Yardstick& yardstick,
                               const RunLimits& limits, const algebra::Progress& progress = {});

}  // namespace coppermoon::verbs
