// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plan/plan.h"

namespace coppermoon::uses {

/// Largest number of copies of a photon that can be spread around the axis of the shadow.
inline constexpr double most_replicas = 1000;

/// A solver and its settings. A setting that the solver does not have is 0.
struct Trial {
  plan::Solver solver = plan::Solver::quadrature;
  double photons = 0, step_km = 0, wavelengths = 200, rays = 0;
  /// Copies of each photon, spaced evenly around the shadow's axis. Light is binned into 1000 / replicas sectors.
  double replicas = 0;
  double texture_width = 512;

  bool operator==(const Trial&) const = default;
};

/// Trials that differ only in one setting.
struct Sweep {
  Trial middle;
  std::string_view varied;
  double Trial::*setting;
  std::vector<double> values;  ///< in order of increasing computing time

  std::vector<Trial> trials() const;
};

/// Name of the varied setting in the sweep that times only the baking of textures. Their light is from the quadrature.
inline constexpr std::string_view texture_sweep = "texture width";

std::vector<std::string> solver_names();

/// Sweeps over every setting of every solver.
///
/// Given  quick     whether to use few and small values
///        replicas  largest number of copies that the air allows: 1000 if it is symmetric about the axis, otherwise 500
std::vector<Sweep> sweeps(bool quick, double replicas);

/// The sweeps that belong to the given solvers.
///
/// Given  solvers  names from solver_names(); if empty, all
std::vector<Sweep> sweeps_of(std::span<const std::string> solvers, std::vector<Sweep> sweeps);

}  // namespace coppermoon::uses
