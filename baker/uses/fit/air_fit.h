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

/// How well a model's light fits measurements.
struct GoodnessOfFit {
  double chi_squared;
  double clock_s = 0,
         clock_variance_s2 =
             0;  ///< mean and variance of the correction to be added to the clock's instants
};

/// Measurements from one night, or the magnitudes measured at one moment.
struct DataSet {
  FittedLight light;
  std::function<GoodnessOfFit(const algebra::Grid<double>& light)>
      goodness;       ///< for given light in bins
  std::size_t count;  ///< number of measurements
};

/// Correction for a clock, to be added to its instants.
struct ClockError {
  double seconds = 0, error_s = 0;  ///< mean and standard error
  std::string zone{};  ///< time zone of its instants; empty if they were given in another way
};

/// Air fitted to data sets.
struct AirFit {
  Unknowns unknowns = Unknowns::factors;
  Posterior posterior{};         ///< of the unknowns, or of their logarithms if unknowns_of says so
  std::size_t measurements = 0;  ///< number of measurements
  AirNumbers best{};             ///< air with the least χ²
  std::vector<ClockError> clocks{};  ///< one for each data set
};

/// Posterior of the air, given all data sets. It is computed on a grid over the range where their light is known. The
/// grid is refined around the probable air, two to five times, until its steps are within a standard deviation. All
/// data sets must have the same unknowns. If the least χ² exceeds the degrees of freedom by more than one standard
/// deviation, which is more than chance explains, all errors are scaled up to match.
AirFit fitted_air(std::span<const DataSet> data, const algebra::Progress& progress = {});

/// Range of the unknowns around their probable values: it extends three widths of the interval beyond the interval, but
/// at least a quarter of the amount for aerosol and cloud, and a tenth for ozone.
AirRange range_about(const AirFit& fit);

/// Whether the interval of each unknown lies inside a range by at least its own width. Ends that the range shares with
/// the prior do not count.
bool is_well_within(const AirFit& fit, const AirRange& range);

/// Largest χ² of an acceptable fit: ten times the degrees of freedom, as if all errors were three times as large
/// as assumed.
///
/// Source  χ² per degree of freedom in tests/end_to_end/recovery_test.cpp: 0.2 to 3.2 for a hundred photographs;
///         for one of them 15 with a tone curve of power 0.7, 98 with a time 30 minutes off, and 388 when taken
///         from another eclipse
double most_chi_squared(const AirFit& fit);

/// Whether the χ² of a fit is at most most_chi_squared.
bool explains(const AirFit& fit);

}  // namespace coppermoon::uses
