// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "uses/fit/fitted_light.h"
#include "uses/fit/posterior.h"

namespace coppermoon::uses {

/// How light agrees with what was seen.
struct Weighed {
  double chi_squared;
  double clock_s = 0,
         clock_variance_s2 = 0;  ///< to be added to instants, and how well that is known
};

/// Numbers that tell of the air: photographs', or magnitudes.
struct Witness {
  const FittedLight* light;
  std::function<Weighed(const algebra::Grid<double>& light)> weighed;  ///< light on its bins
  std::size_t count;                                                   ///< how many numbers
};

/// The error of a clock: what is to be added to instants.
struct ClockError {
  double seconds = 0, error_s = 0;  ///< expectation and standard error
};

/// The air that some witnesses tell of.
struct AirFit {
  Posterior posterior{};             ///< unknowns: logarithm of dust [1/m], cloud cover, ozone [DU]
  std::size_t numbers = 0;           ///< how many were compared
  std::array<double, 3> best{};      ///< dust [1/m], cover, ozone [DU] of the least χ²
  std::vector<ClockError> clocks{};  ///< of each witness
};

/// The air that explains all of them best. Where even that is further off than the errors say, all
/// errors are taken to be as much larger.
AirFit fitted_air(std::span<const Witness> witnesses, const algebra::Progress& progress = {});

/// Largest χ² at which air explains what was seen: ten for each number above the three unknowns, as if all
/// errors were three times as large as believed.
///
/// Source  a hundred photographs of tests/end_to_end/recovery_test.cpp: 0.2 to 3.2; of one of them with
///         a tone curve of the power 0.7: 15, at a time 30 minutes off: 98, of another eclipse: 388
double most_chi_squared(const AirFit& fit);

/// Whether χ² is no larger than that.
bool explains(const AirFit& fit);

}  // namespace coppermoon::uses
