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
             0;  ///< mean [s] and variance [s²] of the correction to be added to the camera's times
};

/// Measurements from one night, or the magnitudes measured at one moment.
struct DataSet {
  FittedLight light;
  std::function<GoodnessOfFit(const algebra::Grid<double>& light)>
      goodness;            ///< goodness of fit of the given light to these data
  std::size_t count;       ///< number of measurements
  double least_scale = 1;  ///< a fit to these data enlarges all variances at least by this factor
};

/// Correction to be added to the times of a camera's clock.
struct ClockError {
  double seconds = 0, error_s = 0;  ///< mean of the correction, and its standard error
  std::string zone{};               ///< time zone of the camera's times; empty if no zone was given
};

/// Result of fitting the air to data sets.
struct AirFit {
  Unknowns unknowns = Unknowns::factors;
  Posterior posterior{};             ///< posterior of the unknowns, or of their logarithms
  std::size_t measurements = 0;      ///< number of measurements
  AirNumbers best{};                 ///< values of the unknowns at the least χ²
  std::vector<ClockError> clocks{};  ///< one correction for each data set
};

/// Fits the air to all data sets together. All data sets must have the same unknowns. The posterior is computed on a
/// grid over the range of the unknowns for which the light of every data set is computed. The grid is then refined
/// around the probable values, two to five times, until its steps are smaller than a standard deviation. If the least
/// χ² exceeds the degrees of freedom by more than one standard deviation, all variances are enlarged until it does not.
/// They are enlarged at least by the greatest least_scale of the data sets.
AirFit fitted_air(std::span<const DataSet> data, const algebra::Progress& progress = {});

/// Range of the unknowns around their probable values. It extends beyond each 68 % interval by three times the
/// interval's width, or by a quarter of the value (a tenth for ozone) if that is more.
AirRange range_about(const AirFit& fit);

/// Whether the 68 % interval of each unknown is at least its own width away from both ends of a range. An end that
/// coincides with a limit of the prior does not count.
bool is_well_within(const AirFit& fit, const AirRange& range);

/// Largest χ² of an acceptable fit: ten times the degrees of freedom, as if errors were three times those assumed.
///
/// Source  χ² per degree of freedom in tests/end_to_end/recovery_test.cpp: 0.2 to 3.2 for a hundred photographs; for
///         one of these photographs, 15 with a tone curve of power 0.7, 98 with a time wrong by 30 minutes, and 388
///         with the date of another eclipse
double most_chi_squared(const AirFit& fit);

/// Whether the fit is acceptable, which means that its χ² does not exceed most_chi_squared.
bool explains(const AirFit& fit);

}  // namespace coppermoon::uses
