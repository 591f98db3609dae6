// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plan/plan.h"

namespace coppermoon::uses {

/// Largest number of replicas of a photon about the axis.
inline constexpr double most_replicas = 1000;

/// Solver and its settings; 0 where the solver has no such setting.
struct Trial {
  plan::Solver solver = plan::Solver::quadrature;
  double photons = 0, step_km = 0, wavelengths = 200, rays = 0;
  /// copies of each photon, evenly about the axis: gathered in 1000 / replicas sectors
  double replicas = 0;
  double texture_width = 512;

  bool operator==(const Trial&) const = default;
};

/// Trials that differ in one setting.
struct Sweep {
  Trial middle;
  std::string_view varied;
  double Trial::*setting;
  std::vector<double> values;  ///< in order of time

  std::vector<Trial> trials() const;
};

/// Setting of the sweep that times the bake alone, in the quadrature's light.
inline constexpr std::string_view texture_sweep = "texture width";

/// Names of all solvers.
std::vector<std::string> solver_names();

/// Sweeps of every solver over every setting.
///
/// Given  quick     few and small values
///        replicas  the most that the air allows: 1000 where it is symmetric about the axis, else half
std::vector<Sweep> sweeps(bool quick, double replicas);

/// Sweeps of some solvers.
///
/// Given  solvers  names from solver_names(); empty: all
std::vector<Sweep> sweeps_of(std::span<const std::string> solvers, std::vector<Sweep> sweeps);

}  // namespace coppermoon::uses
