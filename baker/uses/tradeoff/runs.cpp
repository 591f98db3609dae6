// SPDX-License-Identifier: MIT
#include "uses/tradeoff/runs.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "shadow/by_photons.h"
#include "shadow/by_quadrature.h"
#include "uses/light/spectral_bands.h"

namespace coppermoon::uses {
namespace {

shadow::PhotonSettings photon_settings(const Trial& trial) {
  shadow::PhotonSettings settings;
  settings.photons = static_cast<std::uint64_t>(trial.photons);
  settings.literal = trial.solver == plan::Solver::literal;
  if (trial.step_km > 0) settings.stepping.step_m = trial.step_km * 1e3;
  if (trial.rays > 0) settings.rays = static_cast<int>(trial.rays);
  settings.sectors = static_cast<std::size_t>(std::lround(most_replicas / trial.replicas));
  return settings;
}

shadow::RefractedLight light_by(const Trial& trial, const Yardstick& yardstick,
                                const algebra::Progress& progress) {
  const auto& scene = yardstick.scene();
  const auto waves = wavelengths_nm(static_cast<int>(trial.wavelengths));
  if (trial.solver == plan::Solver::quadrature)
    return shadow::by_quadrature(scene.air, scene.arrangement, waves, yardstick.axis_distances_m(),
                                 {.rays = static_cast<int>(trial.rays)}, progress);
  return shadow::by_photons(scene.air, scene.arrangement, waves, photon_settings(trial), progress);
}

/// Amount of work in a trial, in arbitrary units. Computing time grows linearly with it.
double work_of(const Trial& trial) {
  return trial.photons / (trial.step_km > 0 ? trial.step_km : 1);
}

bool differ_in_work_alone(Trial one, const Trial& other) {
  one.photons = other.photons;
  one.step_km = other.step_km;
  return one == other;
}

/// The measured trial with the most work among those with no more work than `trial` and otherwise equal settings.
/// nullptr if there is no such trial, and always for the quadrature.
const Measured* nearest_smaller(const Trial& trial, std::span<const Measured> made) {
  const Measured* nearest = nullptr;
  for (const auto& one : made)
    if (!one.extrapolated && one.varied != texture_sweep && trial.photons > 0 &&
        differ_in_work_alone(one.trial, trial) && work_of(one.trial) <= work_of(trial) &&
        (nearest == nullptr || work_of(one.trial) > work_of(nearest->trial)))
      nearest = &one;
  return nearest;
}

/// A trial's results, extrapolated from those of a smaller trial. Errors scale as N^(-1/2) with N photons.
Measured extrapolated(const Measured& from, const Trial& trial, double seconds) {
  Measured far = from;
  far.trial = trial;
  far.extrapolated = true;
  far.seconds = seconds;
  const double fewer = std::sqrt(from.trial.photons / trial.photons);
  auto& [umbra, penumbra, picture] = far.errors;
  for (double* error : {&umbra.rms, &umbra.worst, &penumbra.rms, &penumbra.worst, &picture.mean,
                        &picture.percentile_99})
    *error *= fewer;
  return far;
}

/// Runs trials, and keeps their times and errors.
class Run {
 public:
  Run(const RunLimits& limits, Yardstick& yardstick) : limits_(limits), yardstick_(yardstick) {}

  std::vector<Measured> all(std::span<const Sweep> sweeps, const algebra::Progress& progress) {
    for (const auto& sweep : sweeps) trials_ += sweep.values.size();
    if (progress)
      progress_ = [this, &progress](double part) {
        progress((static_cast<double>(made_.size()) + part) / static_cast<double>(trials_));
      };
    for (const auto& sweep : sweeps) make(sweep);
    return std::move(made_);
  }

 private:
  void make(const Sweep& sweep) {
    if (sweep.varied == texture_sweep) return make_textures(sweep);
    for (const auto& trial : sweep.trials()) {
      auto one = measured(trial);
      one.varied = sweep.varied;
      one.value = trial.*sweep.setting;
      made_.push_back(one);
    }
  }

  Measured measured(const Trial& trial) {
    if (const auto* smaller = nearest_smaller(trial, made_)) {
      if (smaller->trial == trial) return *smaller;
      const double at_most_s = smaller->seconds * work_of(trial) / work_of(smaller->trial);
      const double foretold_s = at_most_s > limits_.longest_s ? foretold_seconds(trial) : at_most_s;
      if (foretold_s > limits_.longest_s) return extrapolated(*smaller, trial, foretold_s);
    }
    shadow::RefractedLight light;
    const double seconds = timed(trial, light);
    return {trial, {}, 0, seconds, yardstick_.errors_of(light, trial.photons > 0), false};
  }

  /// The shortest time of several runs of a trial [s]. There are at least three runs if the first is short.
  double least_seconds(const Trial& trial, const std::function<void()>& run) const {
    double least = limits_.stopwatch(trial, run);
    const int repeat = least < limits_.short_s ? std::max(limits_.repeat, 3) : limits_.repeat;
    for (int i = 1; i < repeat; ++i) least = std::min(least, limits_.stopwatch(trial, run));
    return least;
  }

  double timed(const Trial& trial, shadow::RefractedLight& light) {
    const double seconds =
        least_seconds(trial, [&] { light = light_by(trial, yardstick_, progress_); });
    timed_.push_back({trial, seconds});
    return seconds;
  }

  /// Expected time for a trial [s]. It lies on a straight line through the times of the two trials from least_and_most.
  /// If these times hardly differ, larger trials are timed first.
  double foretold_seconds(const Trial& trial) {
    constexpr double shows = 1.5, larger = 4;
    for (;;) {
      const auto [least, most] = least_and_most(trial);
      const double more = work_of(trial) - work_of(most.trial);
      if (more <= 0) return most.seconds;
      if (most.seconds > shows * least.seconds)
        return most.seconds +
               more * (most.seconds - least.seconds) / (work_of(most.trial) - work_of(least.trial));
      Trial probe = trial;
      probe.photons *= std::min(1., larger * work_of(most.trial) / work_of(trial));
      shadow::RefractedLight unused;
      timed(probe, unused);
    }
  }

  struct Timed {
    Trial trial;
    double seconds;
  };

  /// The timed trials with the least and the most work, among those with no more work than `trial` and otherwise equal
  /// settings.
  std::pair<Timed, Timed> least_and_most(const Trial& trial) const {
    std::vector<Timed> alike;
    for (const auto& one : timed_)
      if (differ_in_work_alone(one.trial, trial) && work_of(one.trial) <= work_of(trial))
        alike.push_back(one);
    const auto [least, most] =
        std::ranges::minmax(alike, {}, [](const Timed& one) { return work_of(one.trial); });
    return {least, most};
  }

  /// Times the baking of a texture of each width, and compares its picture with that from the widest texture.
  void make_textures(const Sweep& sweep) {
    constexpr std::size_t most_pixels = 1024;
    const auto light = light_by(sweep.middle, yardstick_, {});
    const auto errors = yardstick_.errors_of(light, false);
    const auto widest = static_cast<std::size_t>(sweep.values.back());
    const auto reference = yardstick_.baked(light, widest);
    for (const auto& trial : sweep.trials()) {
      texture::Image texture;
      const double seconds = least_seconds(trial, [&] {
        texture = yardstick_.baked(light, static_cast<std::size_t>(trial.texture_width));
      });
      made_.push_back({trial, sweep.varied, trial.texture_width, seconds, errors, false});
      made_.back().errors.picture =
          yardstick_.picture_errors(reference, texture, std::min(widest / 2, most_pixels));
    }
  }

  const RunLimits& limits_;
  Yardstick& yardstick_;
  algebra::Progress progress_;
  std::size_t trials_ = 0;
  std::vector<Measured> made_;
  std::vector<Timed> timed_;
};

}  // namespace

algebra::ByName<std::optional<double>> settings_of(const Trial& trial) {
  algebra::ByName<std::optional<double>> all;
  const auto add = [&](const char* key, double value) {
    all.emplace_back(key, value == 0 ? std::nullopt : std::optional(value));
  };
  add("photons", trial.photons), add("step_km", trial.step_km);
  add("wavelengths", trial.wavelengths), add("rays", trial.rays);
  add("replicas", trial.replicas), add("texture_width", trial.texture_width);
  return all;
}

double seconds_of(const Trial&, const std::function<void()>& run) {
  const auto start = std::chrono::steady_clock::now();
  run();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::vector<Measured> measured_trials(std::span<const Sweep> sweeps, Yardstick& yardstick,
                                      const RunLimits& limits, const algebra::Progress& progress) {
  return Run(limits, yardstick).all(sweeps, progress);
}

}  // namespace coppermoon::uses
