// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

#include "uses/light/air.h"

namespace coppermoon::uses {

/// The kind of the three numbers by which a fit describes aerosol, cloud and ozone.
enum class Unknowns {
  factors,  ///< factors on the month's stratospheric aerosol, chance of cloud, and ozone
  amounts  ///< dust [1/m], share of the limb under a deck of cloud (replaces the chance of cloud), ozone [DU]
};

/// One unknown: its name as a parameter of the air, and its prior between two limits. The prior is uniform, or normal on
/// the posterior's axis around the month's air, which differs from the mean of its month.
struct Unknown {
  std::string_view parameter;  ///< "stratospheric-factor"
  std::string_view key;        ///< in JSON and Python: "stratospheric_factor"
  std::string_view title;      ///< "stratospheric aerosol"
  std::string_view unit;       ///< empty for a pure number
  double least, most;
  bool logarithmic;  ///< whether the posterior's axis is the logarithm
  double
      deviation;  ///< standard deviation of a normal prior around 1, on the posterior's axis; 0 if it is uniform

  /// Convert a value to its place on a posterior's axis, and back. The place is the value's logarithm if the prior is
  /// logarithmic, else the value itself.
  double on_axis(double value) const;
  double from_axis(double place) const;

  /// Contribution of a normal prior to χ²; 0 if it is uniform.
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

/// Kind of unknowns that suits an air: factors if it has a chance of cloud and a month's aerosol, else amounts.
Unknowns usual_unknowns(const Air& air);

/// Air with all fitted factors set to 1, so that fitted factors are the parameters' values themselves.
Air with_unit_factors(Air air);

/// Air with the unknowns set to the given values.
Air with_unknowns(Air air, Unknowns unknowns, const AirNumbers& numbers);

}  // namespace coppermoon::uses
