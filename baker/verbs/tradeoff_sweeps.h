// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace coppermoon::verbs {

/// Times that a photon may count about the axis.
inline constexpr double most_replicas = 1000;

/// One way to the light, and all its settings; 0 where a solver has no such setting.
struct Trial {
  std::string_view solver;
  double photons = 0, step_km = 0, wavelengths = 200, rays = 0;
  /// of each photon, evenly about the axis: it is gathered in 1000 / replicas sectors
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

inline constexpr std::string_view quadrature = "quadrature", photons_by_table = "photons by table",
                                  photons_marched = "photons marched",
                                  photons_literal = "photons literal";

/// A sweep of the bake alone, in the quadrature's light.
inline constexpr std::string_view texture_width = "texture width";

std::vector<std::string> solver_names();

/// The whole frontier.
///
/// Given  quick          few values, small ones
///        replicas  most that the air allows: 1000 where it is alike all around
std::vector<Sweep> sweeps(bool quick, double replicas);

}  // namespace coppermoon::verbs
