// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plan/plan.h"

namespace coppermoon::uses {

/// Largest number of replicas of a photon around the axis.
inline constexpr double most_replicas = 1000;

/// A solver and its settings; 0 for a setting that the solver does not have.
struct Trial {
  plan::Solver solver = plan::Solver::quadrature;
  double photons = 0, step_km = 0, wavelengths = 200, rays = 0;
  /// copies of each photon, spread evenly around the axis; light is gathered in 1000 / replicas sectors
  double replicas = 0;
  double texture_width = 512;

  bool operator==(const Trial&) const = default;
};

/// Trials that differ only in one setting.
struct Sweep {
  Trial middle;
  std::string_view varied;
  double Trial::*setting;
  std::vector<double> values;  ///< in order of increasing time

  std::vector<Trial> trials() const;
};

/// Name of the setting in the sweep that times only the bake, with light from the quadrature.
inline constexpr std::string_view texture_sweep = "texture width";

/// Names of all solvers.
std::vector<std::string> solver_names();

/// Sweeps over every setting of every solver.
///
/// Given  quick     use few and small values
///        replicas  the most that the air allows: 1000 if it is symmetric about the axis, otherwise half as many
std::vector<Sweep> sweeps(bool quick, double replicas);

/// The sweeps that belong to some solvers.
///
/// Given  solvers  names from solver_names(); if empty, all
std::vector<Sweep> sweeps_of(std::span<const std::string> solvers, std::vector<Sweep> sweeps);

}  // namespace coppermoon::uses
