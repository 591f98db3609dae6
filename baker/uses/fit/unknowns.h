// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

#include "uses/light/air.h"

namespace coppermoon::uses {

/// Unknowns of the air that a fit looks for: three numbers, of aerosol, of cloud and of ozone.
enum class Unknowns {
  factors,  ///< on the month's stratospheric aerosol, on its chance of cloud, on its ozone
  amounts  ///< dust [1/m], share of the limb under a deck of cloud (in place of cloud by chance), ozone [DU]
};

/// One unknown: its name, as a parameter of the air has it, and its prior, which is uniform between two limits.
struct Unknown {
  std::string_view parameter;  ///< "stratospheric-factor"
  std::string_view key;        ///< of JSON and Python: "stratospheric_factor"
  std::string_view title;      ///< "stratospheric aerosol"
  std::string_view unit;       ///< empty: a pure number
  double least, most;
  bool logarithmic;  ///< whether the prior is uniform in the logarithm

  /// Place of a value on a posterior's axis, the logarithm where that is uniform; and the value of a place.
  double on_axis(double value) const;
  double from_axis(double place) const;
};

/// Numbers of the unknowns: aerosol, cloud, ozone.
using AirNumbers = std::array<double, 3>;

/// The three unknowns, in the order of AirNumbers.
///
///     factors   stratospheric-factor 0.1 to 20, cloud-chance 0.05 to 5 (both logarithmic), ozone-factor 0.4 to 1.7
///     amounts   dust-extinction 2e-7 to 3e-5 1/m (logarithmic), cloud-cover 0 to 1, ozone-du 100 to 500
const std::array<Unknown, 3>& unknowns_of(Unknowns unknowns);

/// Limits of the unknowns' numbers: least and most of aerosol, of cloud and of ozone.
using AirRange = std::array<std::array<double, 2>, 3>;

/// Limits of the unknowns' priors.
AirRange whole_range(Unknowns unknowns);

/// Unknowns that suit an air: factors where it has cloud by chance and aerosol of a month, else amounts.
Unknowns usual_unknowns(const Air& air);

/// Air with all fitted factors 1: factors on it are then values of the parameters.
Air with_unit_factors(Air air);

/// Air of a request with these numbers of the unknowns, as a bake takes it.
Air with_unknowns(Air air, Unknowns unknowns, const AirNumbers& numbers);

}  // namespace coppermoon::uses
