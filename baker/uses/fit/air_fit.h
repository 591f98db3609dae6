// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "uses/fit/fitted_light.h"
#include "uses/fit/posterior.h"

namespace coppermoon::uses {

/// Goodness of fit of a model's light.
struct GoodnessOfFit {
  double chi_squared;
  double clock_s = 0,
         clock_variance_s2 = 0;  ///< of the clock's correction, to be added to instants
};

/// Measurements of one night, or of one moment's magnitudes.
struct DataSet {
  FittedLight light;
  std::function<GoodnessOfFit(const algebra::Grid<double>& light)> goodness;  ///< of light in bins
  std::size_t count;                                                          ///< of measurements
};

/// Correction of a clock, to be added to its instants.
struct ClockError {
  double seconds = 0, error_s = 0;  ///< mean and standard error
  std::string zone{};               ///< that its instants were told in; empty: another way
};

/// Air fitted to data sets.
struct AirFit {
  Unknowns unknowns = Unknowns::factors;
  Posterior posterior{};             ///< of the unknowns, logarithms where unknowns_of has them
  std::size_t measurements = 0;      ///< number of them
  AirNumbers best{};                 ///< of the least χ²
  std::vector<ClockError> clocks{};  ///< by data set
};

/// Posterior of the air, given all data sets: a grid over the range in which their light is known, made finer about
/// what is probable, twice to five times, until its steps are within a standard deviation. All data sets have light of
/// the same unknowns. Where the least χ² exceeds the degrees of freedom by more than one standard deviation, which
/// chance may explain, all errors are scaled up to match.
AirFit fitted_air(std::span<const DataSet> data, const algebra::Progress& progress = {});

/// Range of the unknowns about what is probable: three widths of the interval beyond it, at least a quarter of the
/// amount of aerosol and cloud, a tenth of that of ozone.
AirRange range_about(const AirFit& fit);

/// Whether the interval of each unknown is inside a range, by its own width at least, where that ends before the prior.
bool is_well_within(const AirFit& fit, const AirRange& range);

/// Largest χ² of an acceptable fit: ten times the degrees of freedom, as if all errors were three times as large
/// as believed.
///
/// Source  χ² per degree of freedom of a hundred photographs of tests/end_to_end/recovery_test.cpp: 0.2 to 3.2;
///         of one of them with a tone curve of the power 0.7: 15, at a time 30 minutes off: 98, of another
///         eclipse: 388
double most_chi_squared(const AirFit& fit);

/// Whether χ² is at most most_chi_squared.
bool explains(const AirFit& fit);

}  // namespace coppermoon::uses
