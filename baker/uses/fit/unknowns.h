// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

#include "uses/light/air.h"

namespace coppermoon::uses {

/// Kind of the three numbers with which a fit describes aerosol, cloud and ozone.
enum class Unknowns {
  factors,  ///< factors on the month's mean stratospheric aerosol, chance of cloud, and ozone
  amounts  ///< dust [1/m], share of the limb under a deck of cloud (replaces the chance of cloud), ozone [DU]
};

/// One unknown of the air, and its prior between limits. On the posterior's axis, an amount has a uniform prior. The
/// prior of a factor is normal about 1, the month's mean, because any one night differs from the mean.
struct Unknown {
  std::string_view parameter;  ///< option name, such as "stratospheric-factor"
  std::string_view key;        ///< key in JSON and Python, such as "stratospheric_factor"
  std::string_view title;      ///< title, such as "stratospheric aerosol"
  std::string_view unit;       ///< unit; empty for a pure number
  double least, most;
  bool logarithmic;  ///< whether the posterior's axis is logarithmic
  double
      deviation;  ///< standard deviation of a normal prior around 1, on the posterior's axis; 0 for a uniform prior

  /// Convert a value to its place on the posterior's axis, and back. The place is the value's logarithm if the axis is
  /// logarithmic, else the value itself.
  double on_axis(double value) const;
  double from_axis(double place) const;

  /// Contribution of the prior to χ²; 0 if the prior is uniform.
  double chi_squared_of_prior(double place) const;
};

/// Values of the unknowns: aerosol, cloud, ozone.
using AirNumbers = std::array<double, 3>;

/// The three unknowns, in the order of AirNumbers.
///
///     factors   stratospheric-factor 0.1 to 20, cloud-chance 0.05 to 5 (both logarithmic), ozone-factor 0.4 to 1.7
///     amounts   dust-extinction 2e-7 to 3e-5 1/m (logarithmic), cloud-cover 0 to 1, ozone-du 100 to 500
const std::array<Unknown, 3>& unknowns_of(Unknowns unknowns);

/// Limits of the unknowns: least and greatest value for aerosol, cloud and ozone.
using AirRange = std::array<std::array<double, 2>, 3>;

/// Limits of the priors of all three unknowns.
AirRange whole_range(Unknowns unknowns);

/// Default unknowns for a given air: factors if the air is a month's mean without a deck of cloud, else amounts.
Unknowns usual_unknowns(const Air& air);

/// The air with all factors set to 1. A factor fitted to it is then the value for the air's own parameter.
Air with_unit_factors(Air air);

/// Air with the unknowns set to the given values.
Air with_unknowns(Air air, Unknowns unknowns, const AirNumbers& numbers);

}  // namespace coppermoon::uses
