// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace coppermoon::uses {

/// Largest number of times that a photon may count about the axis.
inline constexpr double most_replicas = 1000;

/// One way to the light, and all its settings; 0 where a solver has no such setting.
struct Trial {
  std::string_view solver;
  double photons = 0, step_km = 0, wavelengths = 200, rays = 0;
  /// times that each photon counts, evenly about the axis: gathered in 1000 / replicas sectors
  double replicas = 0;
  double precision_bits = 64;
  double texture_width = 512;

  bool operator==(const Trial&) const = default;
};

/// One setting varied, the others as in the middle.
struct Sweep {
  Trial middle;
  std::string_view varied;
  double Trial::*setting;
  std::vector<double> values;  ///< cheap ones first

  std::vector<Trial> trials() const;
};

/// Solvers by their names.
inline constexpr std::string_view quadrature_solver = "quadrature",
                                  table_solver = "photons by table",
                                  marching_solver = "photons marched",
                                  step_by_step_solver = "photons literal";

/// What a sweep of the bake alone varies, in the quadrature's light.
inline constexpr std::string_view texture_sweep = "texture width";

/// Names of all solvers.
std::vector<std::string> solver_names();

/// Sweeps of every solver over every setting.
///
/// Given  quick     few values, small ones
///        replicas  most that the air allows: 1000 where it is alike all around, else half
std::vector<Sweep> sweeps(bool quick, double replicas);

/// Those of some solvers.
///
/// Given  solvers  some of solver_names(); empty: all
std::vector<Sweep> sweeps_of(std::span<const std::string> solvers, std::vector<Sweep> sweeps);

}  // namespace coppermoon::uses
