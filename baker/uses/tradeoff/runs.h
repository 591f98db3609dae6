// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "algebra/described.h"
#include "algebra/progress.h"
#include "uses/tradeoff/sweeps.h"
#include "uses/tradeoff/yardstick.h"

namespace coppermoon::uses {

/// A trial, the time that it took, and the errors of its light.
struct Measured {
  Trial trial;
  std::string_view varied;  ///< name of the setting that the sweep varies
  double value = 0;         ///< value of the varied setting
  double seconds = 0;
  LightErrors errors;
  bool extrapolated = false;  ///< whether time and errors are extrapolated from smaller trials
};

/// The settings of a trial by name. A setting that the solver does not have is without a value.
algebra::ByName<std::optional<double>> settings_of(const Trial& trial);

template <class Field>
void describe(Field&& is, const Measured& one) {
  namespace unit = algebra::unit;
  is.a("Measured", "Time and error of a trial.");
  is("solver", name(one.trial.solver), "the solver");
  is("varied", one.varied, "setting that its sweep varies");
  is("value", one.value, "value of that setting");
  for (const auto& [key, value] : settings_of(one.trial))
    is(key, value, "setting; none of a solver that has none");
  is("seconds", one.seconds, unit::seconds, "time");
  is("umbra_rms", one.errors.umbra.rms, "relative error in the umbra, root mean square");
  is("umbra_worst", one.errors.umbra.worst, "relative error at the worst place of the umbra");
  is("penumbra_rms", one.errors.penumbra.rms, "relative error in the penumbra, root mean square");
  is("penumbra_worst", one.errors.penumbra.worst,
     "relative error at the worst place of the penumbra");
  is("delta_e_mean", one.errors.picture.mean, "CIEDE2000 of the picture, the mean");
  is("delta_e_99", one.errors.picture.percentile_99, "CIEDE2000 that 99 % of the picture keep");
  is("extrapolated", one.extrapolated, "whether it is extrapolated from smaller trials");
}

/// Function that runs a trial and returns how many seconds it took.
using Stopwatch = std::function<double(const Trial& trial, const std::function<void()>& run)>;

/// A Stopwatch that uses the steady clock.
double seconds_of(const Trial& trial, const std::function<void()>& run);

/// Limits on how long trials may take, and how often they are repeated.
struct RunLimits {
  double longest_s = 20;  ///< longest time; longer photon trials are extrapolated
  int repeat = 1;         ///< runs of each trial (the fastest counts); at least 3 if short
  double short_s = 1;     ///< time below which a run counts as short
  Stopwatch stopwatch = seconds_of;
};

/// Limits for a quick set of trials, which takes only seconds in total.
inline const RunLimits quick_limits{.longest_s = 3, .short_s = 0.1};

/// Runs every trial of the sweeps, in order.
///
/// A trial's time is the time that its solver takes, look-up tables included. In the sweep of texture widths, it is the
/// time for baking the texture, and the picture's error is relative to the widest texture. A photon trial that would
/// take longer than the limit is extrapolated from smaller trials that differ only in photons and step. Its time is a
/// constant for the tables, plus a time proportional to photons / step. Its errors scale as N^(-1/2) with N photons.
///
/// Omits  the saturation of CIEDE2000 above about 10, where an extrapolated value may be as low as half the true value
std::vector<Measured> measured_trials(std::span<const Sweep> sweeps, Yardstick& yardstick,
                                      const RunLimits& limits,
                                      const algebra::Progress& progress = {});

}  // namespace coppermoon::uses
